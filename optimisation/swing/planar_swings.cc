// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/swing/planar_swings.h"

#include <algorithm>
#include <cmath>

#include "kinematics/model/body_tree.h"
#include "kinematics/trajectory/bspline.h"
#include "kinematics/trajectory/swing_curve.h"
#include "planning/plan/sample_plan.h"

namespace gaitwright {
namespace {

constexpr double kParallel = 0.9999;  // cosine of 0.8 degrees
constexpr double kUpright = 0.7;      // sine of the angle between its normal and the vertical

/// Control points of a detour with the same path as the bump of a swing's lift. Found by correcting the error at the
/// places where each point has the most influence.
std::vector<Vector3> DetourOfBump(double lift_m) {
  constexpr int kFree = 18, kAll = kFree + 2 * kFixedSwingPoints, kDegree = 5, kPasses = 40;
  const auto place = [](int free) {  // Greville abscissa of uniform knots
    double sum = 0.0;
    for (int i = 1; i <= kDegree; ++i)
      sum += std::clamp((free + kFixedSwingPoints + i - kDegree) / static_cast<double>(kAll - kDegree), 0.0, 1.0);
    return sum / kDegree;
  };
  SwingCurve curve;
  curve.detour_W.assign(kFree, Vector3::Zero());
  for (int pass = 0; pass < kPasses; ++pass) {
    const SwingCurve last = curve;
    for (int i = 0; i < kFree; ++i) {
      const double u = place(i);
      curve.detour_W[static_cast<std::size_t>(i)].z() += SmoothBump(u).value - Evaluate(last, u).X_WF.translation().z();
    }
  }
  const double scale = lift_m / LiftAtHalfTime(curve);
  for (Vector3& point : curve.detour_W) point *= scale;
  return curve.detour_W;
}

}  // namespace

std::vector<std::optional<Vector3>> PlanesOfLegs(const RobotModel& model) {
  const std::vector<Pose> X_OB = BodyPoses(model, model.standing_joints);
  std::vector<std::optional<Vector3>> planes_B;
  for (const Leg& leg : model.legs) {
    const auto axis = [&](int j) -> Vector3 {
      return X_OB[static_cast<std::size_t>(j) + 1].linear() * model.joints[static_cast<std::size_t>(j)].axis_J;
    };
    const auto slides = [&](int j) { return model.joints[static_cast<std::size_t>(j)].is_prismatic(); };
    const auto turning = std::find_if_not(leg.joints.begin(), leg.joints.end(), slides);
    planes_B.emplace_back();
    if (turning == leg.joints.end()) continue;
    const Vector3 normal = axis(*turning);
    const bool planar = std::all_of(leg.joints.begin(), leg.joints.end(), [&](int j) {
      const double along = std::abs(axis(j).dot(normal));
      return slides(j) ? along < std::sqrt(1.0 - kParallel * kParallel) : along > kParallel;
    });
    if (planar && normal.head<2>().norm() > kUpright) planes_B.back() = normal;
  }
  return planes_B;
}

double LeanSwings(const std::vector<std::optional<Vector3>>& planes_B, const BaseMotion& base,
                  std::vector<SwingTrajectory>& swings) {
  constexpr double kNoLean = 1e-4;  // [m] lateral
  double largest = 0.0;
  for (SwingTrajectory& swing : swings) {
    const std::optional<Vector3>& plane_B = planes_B[static_cast<std::size_t>(swing.foot)];
    if (!plane_B || swing.cruise > 0.0) continue;
    const double half_s = 0.5 * (swing.start_s + swing.end_s);
    const Vector3 normal_W = base(half_s).linear() * *plane_B;
    const double level = normal_W.head<2>().norm();
    if (level < kUpright) continue;
    const Vector3 side_W(normal_W.x() / level, normal_W.y() / level, 0.0);
    const Vector3 off_W = Evaluate(CurveOf(swing), half_s).X_WF.translation() -
                          0.5 * (swing.X_WF_start.translation() + swing.X_WF_end.translation());
    const double change = std::abs(normal_W.dot(off_W)) / level;
    largest = std::max(largest, change);
    if (swing.detour_W.empty() && change < kNoLean) continue;
    if (swing.detour_W.empty()) swing.detour_W = DetourOfBump(swing.lift_m);
    for (Vector3& point : swing.detour_W) point -= normal_W.dot(point) / level * side_W;
  }
  return largest;
}

}  // namespace gaitwright
