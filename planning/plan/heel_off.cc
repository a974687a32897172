// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "kinematics/base/result.h"
#include "kinematics/spatial/rotation.h"
#include "planning/plan/heel_off_internal.h"

namespace gaitwright {

Polygon FrontEdge(const std::vector<Vector2>& sole_F) {
  constexpr double kStraight = 1e-3;  // [m]
  if (sole_F.empty()) throw InvalidArgument("FrontEdge: the foot has no sole");
  const auto behind = [](const Vector2& a, const Vector2& b) { return a.x() < b.x(); };
  const double front = std::max_element(sole_F.begin(), sole_F.end(), behind)->x();
  Polygon edge;
  for (const Vector2& corner : sole_F) {
    if (corner.x() >= front - kStraight) edge.push_back(corner);
  }
  const auto right = [](const Vector2& a, const Vector2& b) { return a.y() < b.y(); };
  std::sort(edge.begin(), edge.end(), right);
  if (edge.size() > 2) edge = {edge.front(), edge.back()};
  return edge;
}

bool StandsOnEdge(const Foothold& foothold, double time_s) {
  constexpr double kTiny = 1e-9;  // [s]
  return foothold.heel_off_s && time_s > *foothold.heel_off_s - kTiny;
}

Polygon SupportAt(const Foot& foot, const Foothold& foothold, const Polygon& support_F, double time_s) {
  return foot.has_sole() && StandsOnEdge(foothold, time_s) ? FrontEdge(foot.sole_F) : support_F;
}

Vector3 EdgeMiddle(const Foot& foot) {
  const Polygon edge = FrontEdge(foot.sole_F);
  const Vector2 middle = 0.5 * (edge.front() + edge.back());
  return {middle.x(), middle.y(), 0.0};
}

Pose TurnedAboutEdge(const Foot& foot, const Pose& X_WF, double pitch_rad) {
  const Vector3 p_FE = EdgeMiddle(foot);
  Pose turned = X_WF;
  turned.linear() = X_WF.linear() * RotationExp(pitch_rad * Vector3::UnitY());
  turned.translation() = X_WF * p_FE - turned.linear() * p_FE;
  return turned;
}

EdgeTurn EdgeTurnOf(const Foot& foot, const Pose& X_WF_flat, const Pose& X_WF) {
  const Vector3 turn_F = RotationLog(X_WF_flat.linear().transpose() * X_WF.linear());
  EdgeTurn turn;
  turn.pitch_rad = turn_F.y();
  turn.turned_rad = std::hypot(turn_F.x(), turn_F.z());
  for (const Vector2& corner : FrontEdge(foot.sole_F)) {
    const Vector3 p_F(corner.x(), corner.y(), 0.0);
    turn.off_m = std::max(turn.off_m, (X_WF_flat * p_F - X_WF * p_F).norm());
  }
  return turn;
}

}  // namespace gaitwright
