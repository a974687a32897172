// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/swing/plan_swings.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "kinematics/trajectory/swing_curve.h"

namespace gaitwright {
namespace {

constexpr double kLiftPerLegLength = 0.12;
constexpr double kMidSwingFrom = 0.35, kMidSwingTo = 0.65;

SwingCurve CurveOf(const SwingTrajectory& swing) {
  return {swing.start_s, swing.end_s, swing.X_WF_start, swing.X_WF_end, swing.lift_m};
}

/// Lowest height of the whole sole over the ground between two fractions of the swing.
double ClearanceBetween(const RobotModel& model, const Terrain& terrain, const SwingTrajectory& swing, double from,
                        double to) {
  const Foot& foot = model.feet[static_cast<std::size_t>(swing.foot)];
  const SwingCurve curve = CurveOf(swing);
  double lowest = std::numeric_limits<double>::infinity();
  constexpr int kSamples = 24;
  for (int i = 0; i <= kSamples; ++i) {
    const double u = from + (to - from) * i / kSamples;
    const Pose X_WF = Evaluate(curve, swing.start_s + u * (swing.end_s - swing.start_s)).X_WF;
    std::vector<Vector2> corners = foot.sole_F;
    if (corners.empty()) corners.push_back(Vector2::Zero());
    for (const Vector2& corner : corners) {
      const Vector3 p = X_WF * Vector3(corner.x(), corner.y(), 0.0);
      lowest = std::min(lowest, p.z() - GroundAt(terrain, p.head<2>()).height_m);
    }
  }
  return lowest;
}

}  // namespace

Result<std::vector<SwingTrajectory>> PlanSwings(const RobotModel& model, const Terrain& terrain,
                                                const FootstepPlan& footsteps, const SwingOptions& options) {
  const double lift = options.height_m > 0.0 ? options.height_m : kLiftPerLegLength * model.leg_length_m();
  const double wanted = options.clearance_m > 0.0 ? options.clearance_m : 0.25 * lift;
  std::vector<SwingTrajectory> swings;
  for (std::size_t i = 0; i < footsteps.footholds.size(); ++i) {
    const Foothold& from = footsteps.footholds[i];
    const auto next = std::find_if(footsteps.footholds.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                                   footsteps.footholds.end(), [&](const Foothold& f) { return f.foot == from.foot; });
    if (next == footsteps.footholds.end()) continue;
    SwingTrajectory swing{from.foot, from.liftoff_s, next->touchdown_s, from.X_WF, next->X_WF, lift, 0.0};
    swing.X_WF_start.translation() += from.roll_W;
    swing.clearance_m = ClearanceBetween(model, terrain, swing, kMidSwingFrom, kMidSwingTo);
    while (swing.clearance_m < wanted) {
      swing.lift_m += std::max(wanted - swing.clearance_m, 0.1 * lift);
      if (swing.lift_m > model.leg_length_m()) {
        return Failure{FailureKind::kInfeasible,
                       "no_clearance",
                       "PlanSwings",
                       fmt::format("the swing of foot '{}' at {:.2f} s cannot clear the ground by {:.3f} m",
                                   model.feet[static_cast<std::size_t>(swing.foot)].name, swing.start_s, wanted),
                       {"lower swing.clearance_m or choose other footholds"}};
      }
      swing.clearance_m = ClearanceBetween(model, terrain, swing, kMidSwingFrom, kMidSwingTo);
    }
    swings.push_back(swing);
  }
  std::stable_sort(swings.begin(), swings.end(), [](const auto& a, const auto& b) {
    return a.start_s < b.start_s || (a.start_s == b.start_s && a.foot < b.foot);
  });
  return swings;
}

}  // namespace gaitwright
