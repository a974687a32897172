// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/swing/plan_swings.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "optimisation/swing/refine_swing.h"
#include "planning/plan/sample_plan.h"

namespace gaitwright {
namespace {

constexpr double kLiftPerLegLength = 0.12;

/// Swings of a robot's feet over a terrain.
class SwingPlanner {
 public:
  SwingPlanner(const RobotModel& model, const Terrain& terrain, const SwingOptions& options)
      : model_(model), ground_([&terrain](const Vector2& p_W) {
          const GroundPoint ground = GroundAt(terrain, p_W);
          return ground.patch < 0 ? -std::numeric_limits<double>::infinity() : ground.height_m;
        }) {
    lift_m_ = options.height_m > 0.0 ? options.height_m : kLiftPerLegLength * model.leg_length_m();
    choice_.clearance_m = options.clearance_m > 0.0 ? options.clearance_m : 0.25 * lift_m_;
    choice_.control_points = options.control_points;
    choice_.samples = options.samples;
    for (const Foot& foot : model.feet) undersides_.push_back(UndersideOf(foot));
  }

  Result<SwingTrajectory> Plan(const Foothold& from, const Foothold& to) const {
    SwingTrajectory swing{from.foot, from.liftoff_s, to.touchdown_s, from.X_WF, to.X_WF, lift_m_, 0.0};
    swing.X_WF_start.translation() += from.roll_W;
    if (!Clears(swing) && !Refine(swing) && !Raise(swing)) {
      return Failure{
          FailureKind::kInfeasible,
          "no_clearance",
          "PlanSwings",
          fmt::format("the swing of foot '{}' at {:.2f} s cannot clear the ground by {:.3f} m",
                      model_.feet[static_cast<std::size_t>(swing.foot)].name, swing.start_s, choice_.clearance_m),
          {"lower swing.clearance_m or choose other footholds"}};
    }
    swing.clearance_m = MidSwingClearance(swing);
    return swing;
  }

 private:
  const std::vector<Vector3>& Underside(const SwingTrajectory& swing) const {
    return undersides_[static_cast<std::size_t>(swing.foot)];
  }

  /// The whole clearance in mid swing, and a third of what the ramp asks for on the way there and back; on level ground
  /// a lift that has the one has the other.
  bool Clears(const SwingTrajectory& swing) const {
    constexpr double kRounding = 1e-6, kPart = 0.35;
    return MidSwingClearance(swing) > choice_.clearance_m - kRounding &&
           SpareClearance(CurveOf(swing), Underside(swing), ground_, kPart * choice_.clearance_m) > -kRounding;
  }

  /// By a detour.
  bool Refine(SwingTrajectory& swing) const {
    const Result<RefinedSwing> refined = RefineSwing(CurveOf(swing), Underside(swing), ground_, choice_);
    if (!refined) return false;
    swing.detour_W = refined->curve.detour_W;
    swing.lift_m = LiftAtHalfTime(refined->curve);
    return true;
  }

  /// By more lift, up to the leg's length.
  bool Raise(SwingTrajectory& swing) const {
    while (!Clears(swing)) {
      swing.lift_m += 0.1 * lift_m_;
      if (swing.lift_m > model_.leg_length_m()) return false;
    }
    return true;
  }

  /// Lowest height of the underside where the whole clearance is asked for.
  double MidSwingClearance(const SwingTrajectory& swing) const {
    constexpr double kFrom = kClearanceEnds, kTo = 1.0 - kClearanceEnds;
    constexpr int kSamples = 24;
    const SwingCurve curve = CurveOf(swing);
    double lowest = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= kSamples; ++i) {
      const double u = kFrom + (kTo - kFrom) * i / kSamples;
      const Pose X_WF = Evaluate(curve, swing.start_s + u * (swing.end_s - swing.start_s)).X_WF;
      for (const Vector3& q_F : Underside(swing)) {
        const Vector3 q_W = X_WF * q_F;
        lowest = std::min(lowest, q_W.z() - ground_(q_W.head<2>()));
      }
    }
    return lowest;
  }

  const RobotModel& model_;
  const GroundHeight ground_;
  double lift_m_ = 0.0;
  RefineChoice choice_;
  std::vector<std::vector<Vector3>> undersides_;  // by foot
};

}  // namespace

Result<std::vector<SwingTrajectory>> PlanSwings(const RobotModel& model, const Terrain& terrain,
                                                const FootstepPlan& footsteps, const SwingOptions& options) {
  const SwingPlanner planner(model, terrain, options);
  std::vector<SwingTrajectory> swings;
  for (std::size_t i = 0; i < footsteps.footholds.size(); ++i) {
    const Foothold& from = footsteps.footholds[i];
    const auto next = std::find_if(footsteps.footholds.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                                   footsteps.footholds.end(), [&](const Foothold& f) { return f.foot == from.foot; });
    if (next == footsteps.footholds.end()) continue;
    const Result<SwingTrajectory> swing = planner.Plan(from, *next);
    if (!swing) return swing.failure();
    swings.push_back(*swing);
  }
  std::stable_sort(swings.begin(), swings.end(), [](const auto& a, const auto& b) {
    return a.start_s < b.start_s || (a.start_s == b.start_s && a.foot < b.foot);
  });
  return swings;
}

}  // namespace gaitwright
