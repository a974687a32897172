// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/swing/plan_swings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "optimisation/swing/refine_swing.h"
#include "optimisation/swing/swing_ground.h"
#include "optimisation/swing/swing_lift.h"
#include "planning/plan/sample_plan.h"

namespace gaitwright {
namespace {

constexpr double kClearancePerLift = 0.25;
constexpr double kClearanceInFlight = 0.125;  // share of the whole lift, including the lift for the body's rise

/// Plans the swings of a robot's feet over a terrain.
class SwingPlanner {
 public:
  SwingPlanner(const RobotModel& model, const Terrain& terrain, const SwingOptions& options, const FormerMotion& former)
      : model_(model),
        terrain_(terrain),
        former_(former.swings),
        lift_of_(former.lift_m),
        cruise_(former.cruise),
        reach_(former.reach),
        legs_known_(former.base != nullptr),
        guard_(model, terrain, former) {
    lift_m_ = SwingLift(model, options);
    if (options.height_m == 0.0) speed_bound_.emplace(model);
    clearance_m_ = options.clearance_m;
    choice_.control_points = options.control_points;
    choice_.samples = options.samples;
    for (const Foot& foot : model.feet) undersides_.push_back(UndersideOf(foot));
  }

  Result<SwingTrajectory> Plan(const Foothold& from, const Foothold& to) {
    SwingTrajectory swing{from.foot, from.liftoff_s, to.touchdown_s, from.X_WF, to.X_WF, lift_m_, 0.0};
    swing.X_WF_start.translation() += from.roll_W;
    if (cruise_) swing.cruise = cruise_(swing);
    if (lift_of_) {
      swing.lift_m = lift_of_(swing);
    } else if (speed_bound_) {
      swing.lift_m = speed_bound_->LiftInTime(swing.foot, swing.end_s - swing.start_s, lift_m_);
    }
    choice_.clearance_m = clearance_m_ > 0.0 ? clearance_m_ : kClearancePerLift * std::min(lift_m_, swing.lift_m);
    // Obstacles that begin lower than the foot's path are stepped over.
    const double below_m =
        std::max(swing.X_WF_start.translation().z(), swing.X_WF_end.translation().z()) + swing.lift_m;
    ground_ = [this, below_m](const Vector2& p_W) { return HeightToClear(terrain_, p_W, below_m); };
    hit_.reset();
    unfollowed_.reset();
    choice_.roll = guard_.RollOf(swing);
    choice_.reach = ReachOf(swing);
    choice_.may_stray = false;
    const SwingTrajectory straight = swing;
    // A detour that no leg can follow goes above the obstacle, because another height of the body may allow it. A shank
    // without room is reported by the audit.
    const bool room = guard_.LegHasRoom(swing);
    bool clear = FindHigher(swing, {room, true}) || Find(swing, {room, true});
    if (!clear && legs_known_) clear = Find(swing, {room, false}) || (room && Find(swing, {false, false}));
    // Use the path least out of reach, or any path; the audit checks it.
    choice_.may_stray = true;
    clear = clear || (!choice_.reach.empty() && Find(swing, {room, true}));
    if (!clear && !choice_.reach.empty()) {
      choice_.reach.clear();
      clear = Find(swing, {room, true});
    }
    if (!clear && !hit_) MeetsNothing(straight);  // sets hit_ to the obstacle
    if (!clear) return NoClearance(swing);
    swing.clearance_m = ClearanceOf(swing);
    return swing;
  }

 private:
  /// Requirements on a swing besides its foot's clearance, if the base's motion is known.
  struct LegDemand {
    bool clear = true;    ///< nothing touches the leg
    bool follows = true;  ///< the leg can follow it, for a detour
  };

  bool Find(SwingTrajectory& swing, const LegDemand& demand) {
    demand_ = demand;
    if (TakeFormer(swing)) return true;
    if ((GroundIsPlane(swing) || Clears(swing, 1.0)) && Keeps(swing)) return true;
    if (demand.follows) return Detour(swing);
    if (unfollowed_ && (demand.clear || MeetsNothing(*unfollowed_))) {
      swing = *unfollowed_;
      return true;
    }
    return GoOver(swing);
  }

  /// Searches with a higher clearance for a foot in flight: an eighth of its lift, if that is more and possible. Such a
  /// foot is fast and deviates more from its path.
  bool FindHigher(SwingTrajectory& swing, const LegDemand& demand) {
    const double usual_m = choice_.clearance_m, higher_m = kClearanceInFlight * swing.lift_m;
    if (clearance_m_ > 0.0 || higher_m <= usual_m) return false;
    choice_.clearance_m = higher_m;
    const bool clear = Find(swing, demand);
    choice_.clearance_m = usual_m;
    hit_.reset();
    unfollowed_.reset();
    return clear;
  }

  Failure NoClearance(const SwingTrajectory& swing) const {
    const std::string& foot = model_.feet[static_cast<std::size_t>(swing.foot)].name;
    std::string message = fmt::format("the swing of foot '{}' at {:.2f} s cannot clear the ground by {:.3f} m", foot,
                                      swing.start_s, choice_.clearance_m);
    if (hit_) {
      message += fmt::format(": at {:.2f} s, '{}' is {:.3f} m from '{}'; the required clearance is {:.3f} m",
                             hit_->at_s, hit_->part, hit_->distance_m, hit_->solid, std::max(hit_->asked_m, 0.0));
    }
    return {FailureKind::kInfeasible,
            FailureCode::kNoClearance,
            "PlanSwings",
            message,
            {"lower swing.clearance_m or choose other footholds"}};
  }

  /// Reuses the detour of the former pass if it is still valid: passes converge only if swings do not change.
  bool TakeFormer(SwingTrajectory& swing) {
    constexpr double kSame = 1e-9;  // [s]
    const auto former = std::find_if(former_.begin(), former_.end(), [&](const SwingTrajectory& f) {
      return f.foot == swing.foot && std::abs(f.start_s - swing.start_s) < kSame;
    });
    if (former == former_.end() || former->detour_W.empty()) return false;
    SwingTrajectory again = swing;
    again.detour_W = former->detour_W;
    again.lift_m = former->lift_m;
    if (!MeetsNothing(again) || !Followed(again)) return false;
    swing = again;
    return true;
  }

  /// Keeps the arc of a swing with a cruise phase if possible, so that the foot moves along with the body.
  bool GoOver(SwingTrajectory& swing) {
    return swing.cruise > 0.0 ? Raise(swing) || Refine(swing) : Refine(swing) || Raise(swing);
  }

  /// Prefers a sideways detour to one so high that the leg folds. A clear path that the leg cannot follow is kept as a
  /// fallback.
  bool Detour(SwingTrajectory& swing) {
    if (!choice_.reach.empty()) {  // other paths would be out of reach
      highest_m_ = model_.leg_length_m();
      return GoOver(swing);
    }
    for (const double share : {0.5, 1.0}) {
      highest_m_ = share * model_.leg_length_m();
      if (GoOver(swing)) return true;
      if (unfollowed_) return false;  // lateral and higher paths are no easier to follow
      if (GoAround(swing)) return true;
    }
    return false;
  }

  const std::vector<Vector3>& Underside(const SwingTrajectory& swing) const {
    return undersides_[static_cast<std::size_t>(swing.foot)];
  }

  double ClearanceOf(const SwingTrajectory& swing) const {
    return MidSwingClearance(CurveOf(swing), Underside(swing), ground_, choice_.roll);
  }

  /// Whether all ground under the path is in the plane through both footholds, or below it.
  bool GroundIsPlane(const SwingTrajectory& swing) const {
    constexpr double kLevel = 1e-3;  // [m]
    constexpr int kSamples = 40;
    SwingCurve flat = CurveOf(swing);
    flat.lift_m = 0.0;
    for (int k = 0; k <= kSamples; ++k) {
      const double time_s = swing.start_s + (swing.end_s - swing.start_s) * k / kSamples;
      const Pose X_WF = Evaluate(flat, time_s).X_WF;
      for (const Vector3& q_F : Underside(swing)) {
        const Vector3 q_W = X_WF * Vector3(q_F.x(), q_F.y(), 0.0);
        if (ground_(q_W.head<2>()) > q_W.z() + kLevel) return false;
      }
    }
    return true;
  }

  /// Whether the swing has the full clearance in mid swing, and the share `part` of the ramp's clearance before and
  /// after.
  bool Clears(const SwingTrajectory& swing, double part) const {
    constexpr double kRounding = 1e-6;
    return ClearanceOf(swing) > choice_.clearance_m - kRounding &&
           ClearanceMargin(CurveOf(swing), Underside(swing), ground_, part * choice_.clearance_m, choice_.roll) >
               -kRounding;
  }

  /// Clears, and neither foot nor leg touches anything. On level ground, a lift with the clearance in mid swing has a
  /// third of the ramp's clearance.
  bool Keeps(const SwingTrajectory& swing) { return Clears(swing, kPart) && InReach(swing) && MeetsNothing(swing); }

  bool InReach(const SwingTrajectory& swing) const {
    return OutOfReach(CurveOf(swing), choice_.reach, choice_.roll) <= 0.0;
  }

  /// Reach of the foot along a swing.
  std::vector<ReachAt> ReachOf(const SwingTrajectory& swing) const {
    constexpr double kApart = 3e-3;  // [s]
    constexpr int kLeast = 60;
    std::vector<ReachAt> reach;
    const int pieces = std::max(kLeast, static_cast<int>((swing.end_s - swing.start_s) / kApart));
    for (int k = 1; reach_ && k < pieces; ++k) {
      const double u = static_cast<double>(k) / pieces;
      reach.push_back({u, reach_(swing.foot, swing.start_s + u * (swing.end_s - swing.start_s))});
    }
    return reach;
  }

  /// Checked for detours only; the whole-body stage checks whether the closed-form swing can be followed.
  bool Followed(const SwingTrajectory& swing) const { return !demand_.follows || guard_.LegFollows(swing); }

  bool MeetsNothing(const SwingTrajectory& swing) {
    const std::optional<SwingHit> hit = guard_.Check(swing, kPart * choice_.clearance_m, demand_.clear);
    if (hit) hit_ = hit;
    return !hit;
  }

  /// Finds a detour, with a larger clearance if the requested one is not sufficient.
  bool Refine(SwingTrajectory& swing) {
    RefineChoice choice = choice_;
    for (const double more : {1.0, 1.5, 2.0}) {
      choice.clearance_m = more * choice_.clearance_m;
      if (Refine(swing, choice)) return true;
      if (unfollowed_ && demand_.follows) return false;  // a larger clearance is even harder to follow
    }
    return false;
  }

  bool Refine(SwingTrajectory& swing, const RefineChoice& choice) {
    SwingTrajectory refined = swing;
    const Result<RefinedSwing> found = RefineSwing(CurveOf(swing), Underside(swing), ground_, choice);
    if (!found) return false;
    refined.detour_W = found->curve.detour_W;
    refined.lift_m = LiftAtHalfTime(found->curve);
    if (HighestOf(found->curve) > highest_m_ || !MeetsNothing(refined)) return false;
    if (!Followed(refined)) {
      if (!unfollowed_) unfollowed_ = refined;
      return false;
    }
    swing = refined;
    return true;
  }

  /// Height of the curve above the higher of its ends.
  static double HighestOf(const SwingCurve& curve) {
    constexpr int kSamples = 40;
    const double ends = std::max(curve.X_WF_start.translation().z(), curve.X_WF_end.translation().z());
    double highest = 0.0;
    for (int k = 1; k < kSamples; ++k) {
      const double time_s = curve.start_s + (curve.end_s - curve.start_s) * k / kSamples;
      highest = std::max(highest, Evaluate(curve, time_s).X_WF.translation().z() - ends);
    }
    return highest;
  }

  /// Raises the lift.
  bool Raise(SwingTrajectory& swing) {
    SwingTrajectory raised = swing;
    while (!Keeps(raised) || !Followed(raised)) {
      raised.lift_m += 0.1 * lift_m_;
      if (raised.lift_m > highest_m_) return false;
    }
    swing = raised;
    return true;
  }

  /// Finds a path on either side, up to a third of the leg's length away.
  bool GoAround(SwingTrajectory& swing) {
    constexpr double kFarthest = 0.33;
    constexpr int kTries = 6;
    RefineChoice choice = choice_;
    for (int i = 1; i <= kTries; ++i) {
      for (const double side : {1.0, -1.0}) {
        choice.sideways_m = side * kFarthest * model_.leg_length_m() * i / kTries;
        if (Refine(swing, choice)) return true;
      }
    }
    return false;
  }

  static constexpr double kPart = 0.35;

  const RobotModel& model_;
  const Terrain& terrain_;
  const std::vector<SwingTrajectory> former_;
  const std::function<double(const SwingTrajectory&)> lift_of_, cruise_;
  const std::function<std::vector<ReachSide>(int, double)> reach_;
  const bool legs_known_;  // otherwise legs are not checked
  const SwingGuard guard_;
  GroundHeight ground_;  // for the present swing
  std::optional<SwingHit> hit_;
  std::optional<SwingTrajectory> unfollowed_;  // clear, but the leg cannot follow it
  double lift_m_ = 0.0, highest_m_ = 0.0;
  std::optional<SpeedBoundLift> speed_bound_;  // used if no lift is given
  double clearance_m_ = 0.0;                   // requested clearance; 0 for a share of the lift
  LegDemand demand_;
  RefineChoice choice_;
  std::vector<std::vector<Vector3>> undersides_;  // by foot
};

}  // namespace

Result<std::vector<SwingTrajectory>> PlanSwings(const RobotModel& model, const Terrain& terrain,
                                                const FootstepPlan& footsteps, const SwingOptions& options,
                                                const FormerMotion& former) {
  SwingPlanner planner(model, terrain, options, former);
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
