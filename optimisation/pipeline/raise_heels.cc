// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "kinematics/base/non_finite.h"
#include "kinematics/stability/polygon.h"
#include "optimisation/pipeline/raise_heels_internal.h"
#include "optimisation/swing/refine_swing.h"
#include "optimisation/swing/swing_ground.h"
#include "planning/plan/heel_off_internal.h"
#include "planning/plan/sample_plan.h"
#include "planning/plan/sole_support.h"

namespace gaitwright {
namespace {

/// How far a swing goes forward, in the frame of the sole that it leaves [m].
double ForwardOf(const SwingTrajectory& swing) {
  const Vector3 travel_W = swing.X_WF_end.translation() - swing.X_WF_start.translation();
  return swing.X_WF_start.linear().col(0).dot(travel_W);
}

/// The foothold that a swing leaves; null if there is none.
Foothold* LeftBy(const SwingTrajectory& swing, FootstepPlan& footsteps) {
  constexpr double kSame = 1e-6;  // [s]
  for (Foothold& foothold : footsteps.footholds) {
    if (foothold.foot == swing.foot && std::abs(foothold.liftoff_s - swing.start_s) < kSame) return &foothold;
  }
  return nullptr;
}

bool CarriesFrontEdge(const Foot& foot, const Foothold& foothold, const Terrain& terrain) {
  constexpr double kTiny = 1e-9;  // [m]
  const Polygon support_F = SupportOf(foot, foothold, terrain);
  if (support_F.empty()) return false;
  const Polygon edge_F = FrontEdge(foot.sole_F);
  return std::all_of(edge_F.begin(), edge_F.end(),
                     [&](const Vector2& p_F) { return SignedDistance(support_F, p_F) > -kTiny; });
}

/// Length of the double support that ends with the lift-off of a foothold; nothing if no other foot stands then.
std::optional<double> DoubleSupportBefore(const Foothold& foothold, const ContactSchedule& schedule) {
  constexpr double kSame = 1e-6;  // [s]
  for (const ContactPhase& phase : schedule.phases) {
    if (std::abs(phase.end_s - foothold.liftoff_s) >= kSame) continue;
    if ((phase.stance & ~FootBit(foothold.foot)) == 0) return std::nullopt;
    return phase.end_s - phase.start_s;
  }
  return std::nullopt;
}

/// A step forward, not up, from a sole whose heel can rise before. Swings that climb lead around the edge of a step.
struct Step {
  SwingTrajectory* swing;
  Foothold* foothold;  // that it leaves
  double forward_m, double_support_s;
};

std::vector<Step> StepsWithHeelOff(const RobotModel& model, MotionPlan& plan) {
  constexpr double kLeast = 0.01, kUp = 0.01;  // [m]
  std::vector<Step> steps;
  for (SwingTrajectory& swing : plan.swings) {
    const Foot& foot = model.feet[static_cast<std::size_t>(swing.foot)];
    Foothold* foothold = LeftBy(swing, plan.footsteps);
    const double forward_m = ForwardOf(swing);
    const bool climbs = swing.X_WF_end.translation().z() > swing.X_WF_start.translation().z() + kUp;
    if (foot.type != FootType::kSole || foothold == nullptr || forward_m < kLeast || climbs) continue;
    const std::optional<double> double_support_s = DoubleSupportBefore(*foothold, plan.schedule);
    if (!double_support_s || !CarriesFrontEdge(foot, *foothold, plan.terrain)) continue;
    steps.push_back({&swing, foothold, forward_m, *double_support_s});
  }
  return steps;
}

/// Raises a swing that starts from a turned sole until its whole underside is clear of the ground.
void KeepClear(const Foot& foot, const Terrain& terrain, SwingTrajectory& swing) {
  constexpr double kHigher = 1.1, kHighest = 2.0;
  constexpr double kClearancePerLift = 0.25;
  const double planned_m = swing.lift_m;
  const double below_m = std::max(swing.X_WF_start.translation().z(), swing.X_WF_end.translation().z()) + planned_m;
  const GroundHeight ground = [&](const Vector2& p_W) { return HeightToClear(terrain, p_W, below_m); };
  const std::vector<Vector3> underside_F = UndersideOf(foot);
  const auto is_clear = [&] {
    return ClearanceMargin(CurveOf(swing), underside_F, ground, kClearancePerLift * planned_m) > 0.0;
  };
  while (swing.detour_W.empty() && !is_clear() && kHigher * swing.lift_m <= kHighest * planned_m)
    swing.lift_m *= kHigher;
  swing.clearance_m = MidSwingClearance(CurveOf(swing), underside_F, ground);
}

}  // namespace

void RaiseHeels(const RobotModel& model, const HeelRise& rise, MotionPlan& plan) {
  if (rise.pitch_rad <= 0.0) return;
  const std::vector<Step> steps = StepsWithHeelOff(model, plan);
  double longest_m = 0.0, shortest_s = kInfinity;
  for (const Step& step : steps) {
    longest_m = std::max(longest_m, step.forward_m);
    shortest_s = std::min(shortest_s, step.double_support_s);
  }
  // The first double support lasts long: the heel rises as fast as in the others.
  const double row_s = plan.whole_body.step_s,
               rise_s = row_s * std::max(1.0, std::round(rise.share * shortest_s / row_s));
  for (const Step& step : steps) {
    const Foot& foot = model.feet[static_cast<std::size_t>(step.swing->foot)];
    step.foothold->heel_off_s = step.foothold->liftoff_s - std::min(rise_s, step.double_support_s);
    step.swing->X_WF_start = TurnedAboutEdge(foot, step.foothold->X_WF, step.forward_m / longest_m * rise.pitch_rad);
    KeepClear(foot, plan.terrain, *step.swing);
  }
}

}  // namespace gaitwright
