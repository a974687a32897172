// SPDX-License-Identifier: BSD-3-Clause
#include "planning/footsteps/leg_room.h"

#include <algorithm>
#include <cmath>

#include "kinematics/stability/polygon.h"

namespace gaitwright {

LegRoom::LegRoom(const RobotModel& model, const GroundIndex& ground, double margin_m)
    : ground_(&ground), margin_m_(margin_m), around_m_(0.5 * model.leg_length_m()) {}

bool LegRoom::MayMeet(const Pose& X_WF) const {
  const Vector2 p = X_WF.translation().head<2>(), box = Vector2::Constant(around_m_);
  return ground_->HighestIn(p - box, p + box) > X_WF.translation().z() + 1e-9;
}

bool LegRoom::IsClear(LegWorkspace& workspace, const Foot& foot, const Pose& X_WF, const Pose& X_WB) {
  Pose X_BF = X_WB.inverse() * X_WF;
  X_BF.translation() += foot.radius * X_BF.linear().col(2);
  if (!workspace.BallsAt(X_BF, balls_) || balls_.empty()) return true;
  Vector2 low = X_WF.translation().head<2>(), high = low;
  for (Ball& ball : balls_) {
    ball.centre_B = X_WB * ball.centre_B;
    // Above its own foothold, the leg may be as near to the ground as its foot is.
    const double own = X_WF.linear().col(2).dot(ball.centre_B - X_WF.translation());
    const double close = own > ball.radius_m ? 0.5 * (ball.radius_m + own) : 0.9 * own;
    ball.radius_m = own > 0.0 ? std::min(ball.radius_m + margin_m_, close) : ball.radius_m;
    low = low.cwiseMin(ball.centre_B.head<2>() - Vector2::Constant(ball.radius_m));
    high = high.cwiseMax(ball.centre_B.head<2>() + Vector2::Constant(ball.radius_m));
  }
  const double highest = ground_->HighestIn(low, high);
  ground_->PatchesIn(low, high, near_);
  return std::none_of(balls_.begin(), balls_.end(), [&](const Ball& ball) {
    return ball.centre_B.z() - ball.radius_m < highest && Meets(ball.centre_B, ball.radius_m);
  });
}

bool LegRoom::Meets(const Vector3& p_W, double radius_m) const {
  const auto meets = [&](int i) {
    return MeetsSurface(ground_->surfaces()[static_cast<std::size_t>(i)], p_W, radius_m);
  };
  return std::any_of(near_.begin(), near_.end(), meets) || MeetsField(p_W, radius_m);
}

bool LegRoom::MeetsSurface(const GroundSurface& surface, const Vector3& p_W, double radius_m) const {
  const Vector2 p = p_W.head<2>();
  if ((p_W.z() - surface.HeightAt(p)) * surface.normal_W.z() >= radius_m) return false;
  if (surface.Inside(p) >= 0.0) return true;
  const Vector2 out = (surface.lowest_W - p).cwiseMax(p - surface.highest_W);
  if (out.maxCoeff() >= radius_m) return false;
  const Vector2 q = NearestPoint(surface.outline_W, p);
  const double beside = (q - p).squaredNorm(), square = radius_m * radius_m;
  return beside < square && surface.HeightAt(q) > p_W.z() - std::sqrt(square - beside);
}

bool LegRoom::MeetsField(const Vector3& p_W, double radius_m) const {
  if (ground_->terrain().height_fields.empty()) return false;
  const auto meets = [&](double x, double y) {
    const Vector2 away(x * radius_m, y * radius_m);
    const GroundPoint under = ground_->At(p_W.head<2>() + away);
    return under.patch >= 0 && under.height_m > p_W.z() - std::sqrt(1.0 - x * x - y * y) * radius_m;
  };
  constexpr double kOut = 0.7;  // share of the radius at which the ground around is sampled
  return meets(0.0, 0.0) || meets(kOut, 0.0) || meets(-kOut, 0.0) || meets(0.0, kOut) || meets(0.0, -kOut);
}

}  // namespace gaitwright
