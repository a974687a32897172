// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "kinematics/base/non_finite.h"
#include "kinematics/dynamics/dynamics.h"
#include "kinematics/trajectory/fit_detour.h"
#include "optimisation/swing/former_motion.h"
#include "optimisation/swing/refine_swing.h"
#include "optimisation/swing/swing_ground.h"
#include "optimisation/swing/swing_guard.h"
#include "optimisation/whole_body/finish_problem_internal.h"
#include "optimisation/whole_body/swing_room_internal.h"
#include "planning/plan/sample_plan.h"

namespace gaitwright {
namespace {

constexpr double kSameMoment = 1e-9;  // [s]

/// The swing of a foot at a time inside it; null in stance.
const SwingTrajectory* SwingAt(const MotionPlan& plan, int foot, double time_s) {
  const auto found = std::ranges::find_if(plan.swings, [&](const SwingTrajectory& swing) {
    return swing.foot == foot && swing.start_s < time_s - kSameMoment && time_s < swing.end_s - kSameMoment;
  });
  return found == plan.swings.end() ? nullptr : &*found;
}

/// The highest ground within `beside_m` of a point along both axes.
double HighestBeside(const Terrain& terrain, const Vector2& p_W, double beside_m, double below_m) {
  constexpr int kPieces = 2;  // to either side
  double highest_m = -kInfinity;
  for (int i = -kPieces; i <= kPieces; ++i) {
    for (int j = -kPieces; j <= kPieces; ++j)
      highest_m = std::max(highest_m, HeightToClear(terrain, p_W + beside_m / kPieces * Vector2(i, j), below_m));
  }
  return highest_m;
}

/// Room of a foot around its planned pose in a swing.
class SwingRoom {
 public:
  SwingRoom(const RobotModel& model, const MotionPlan& plan, const SwingFreedom& freedom)
      : plan_(plan), freedom_(freedom), is_plane_(KindOfGround(plan.terrain) != GroundKind::kUneven) {
    for (const Foot& foot : model.feet) undersides_F_.push_back(UndersideOf(foot));
  }

  /// Sets the bounds of a goal at a time of a swing.
  void Set(const SwingTrajectory& swing, double time_s, const Pose& X_WF, FootGoal& goal) const {
    const double share = (time_s - swing.start_s) / (swing.end_s - swing.start_s), ramp = ClearanceRamp(share);
    const double asked_m = ramp * ClearanceToKeep(swing, freedom_);
    constexpr double kLeast = 1e-3;  // [m] of room to the sides
    for (double beside_m = ramp * freedom_.most_m; beside_m > kLeast; beside_m *= 0.5) {
      const double margin_m = HeightOver(swing, X_WF, beside_m) - asked_m;
      if (margin_m < 0.0) continue;
      goal.below = {beside_m, beside_m, std::min(margin_m, ramp * freedom_.most_m), 0.0, 0.0, 0.0};
      goal.above = {beside_m, beside_m, ramp * freedom_.most_m, 0.0, 0.0, 0.0};
      return;
    }
  }

 private:
  /// Height of the underside over all ground that is within reach to the sides.
  double HeightOver(const SwingTrajectory& swing, const Pose& X_WF, double beside_m) const {
    const double below_m =
        std::max(swing.X_WF_start.translation().z(), swing.X_WF_end.translation().z()) + swing.lift_m;
    double height_m = kInfinity;
    for (const Vector3& q_F : undersides_F_[static_cast<std::size_t>(swing.foot)]) {
      const Vector3 q_W = X_WF * q_F;
      const double ground_m = is_plane_
                                  ? HeightToClear(plan_.terrain, q_W.head<2>(), below_m)
                                  : HighestBeside(plan_.terrain, q_W.head<2>(), beside_m + freedom_.shift_m, below_m);
      height_m = std::min(height_m, q_W.z() - ground_m);
    }
    return height_m;
  }

  const MotionPlan& plan_;
  const SwingFreedom freedom_;
  const bool is_plane_;
  std::vector<std::vector<Vector3>> undersides_F_;
};

/// Offsets of a foot's path from the straight move of its swing, at the rows of a motion inside the swing.
struct SwingOffsets {
  std::vector<double> shares;
  std::vector<Vector3> off_W;
};

SwingOffsets OffsetsOf(const RobotModel& model, const MotionPlan& plan, const SwingTrajectory& swing,
                       const FootCourse& course, const std::vector<Vector3>& roll_W, DynamicsScratch& scratch) {
  const WholeBodyTrajectory& motion = plan.whole_body;
  const Foot& foot = model.feet[static_cast<std::size_t>(swing.foot)];
  SwingOffsets offsets;
  const auto first = static_cast<int>(std::ceil((swing.start_s - motion.start_s) / motion.step_s + kSameMoment));
  for (int row = first; row < motion.size(); ++row) {
    const double time_s = motion.start_s + row * motion.step_s;
    if (time_s > swing.end_s - kSameMoment) break;
    if (time_s < swing.start_s + kSameMoment) continue;
    const FootCourse::Place place = course.At(time_s);
    ForwardKinematics(model, motion.q[static_cast<std::size_t>(row)], scratch);
    const Vector3 path_W = FramePose(scratch, foot.body, foot.X_BF).translation() -
                           foot.radius * place.X_WF.linear().col(2) - roll_W[static_cast<std::size_t>(row)];
    // The course is the planned curve between the same ends, so that only its offset is left to be taken away.
    const SwingCurve planned = CurveOf(swing), straight = StraightMoveOf(planned);
    const Vector3 planned_off_W =
        Evaluate(planned, time_s).X_WF.translation() - Evaluate(straight, time_s).X_WF.translation();
    offsets.shares.push_back((time_s - swing.start_s) / (swing.end_s - swing.start_s));
    offsets.off_W.emplace_back(path_W - place.X_WF.translation() + planned_off_W);
  }
  return offsets;
}

}  // namespace

double ClearanceToKeep(const SwingTrajectory& swing, const SwingFreedom& freedom) {
  constexpr double kOfPlanned = 0.5;
  return freedom.clearance_m > 0.0 ? freedom.clearance_m : kOfPlanned * std::max(swing.clearance_m, 0.0);
}

void FreeSwings(const RobotModel& model, const MotionPlan& plan, const std::vector<FootCourse>& courses,
                const SwingFreedom& freedom, BodyProblem& problem) {
  const SwingRoom room(model, plan, freedom);
  for (std::size_t k = 0; k < problem.knots.size(); ++k) {
    const double time_s = problem.time_s[k];
    for (std::size_t i = 0; i < courses.size(); ++i) {
      FootGoal& goal = problem.knots[k].feet[i];
      const SwingTrajectory* swing = SwingAt(plan, goal.foot, time_s);
      if (swing == nullptr) continue;
      Pose X_WF = courses[i].At(time_s).X_WF;
      X_WF.translation() = goal.p_W - model.feet[static_cast<std::size_t>(goal.foot)].radius * goal.normal_W;
      room.Set(*swing, time_s, X_WF, goal);
    }
  }
}

int FitSwings(const RobotModel& model, const SwingFreedom& freedom, MotionPlan& plan) {
  constexpr int kMostPoints = 12, kRowsPerPoint = 2;
  constexpr double kChecked = 0.6;  // of the clearance: feet may be lower between knots, and rise slowly at first
  std::vector<FootCourse> courses = CoursesOf(model, plan);
  const FootRolls rolls = RollsOf(model, plan.whole_body, courses);
  for (std::size_t i = 0; i < courses.size(); ++i)
    courses[i].SetRolls(RolledAtTouchdowns(plan, courses[i], rolls.roll_W[i]));
  const SwingGuard guard(model, plan.terrain, MotionOf(model, plan.whole_body));
  DynamicsScratch scratch(model);
  int fitted = 0;
  std::vector<SwingTrajectory> swings = plan.swings;
  for (SwingTrajectory& swing : swings) {
    const auto course = std::ranges::find(courses, swing.foot, &FootCourse::foot);
    const auto index = static_cast<std::size_t>(course - courses.begin());
    const SwingOffsets offsets = OffsetsOf(model, plan, swing, *course, rolls.roll_W[index], scratch);
    const int points = std::min(kMostPoints, static_cast<int>(offsets.shares.size()) / kRowsPerPoint);
    if (points < 1) continue;
    SwingTrajectory made = swing;
    made.detour_W = FitDetour(offsets.shares, offsets.off_W, points);
    made.lift_m = LiftAtHalfTime(CurveOf(made));
    if (guard.Check(made, kChecked * ClearanceToKeep(swing, freedom), false)) continue;
    const double below_m = std::max(made.X_WF_start.translation().z(), made.X_WF_end.translation().z()) + made.lift_m;
    made.clearance_m = MidSwingClearance(
        CurveOf(made), UndersideOf(model.feet[static_cast<std::size_t>(made.foot)]),
        [&](const Vector2& p_W) { return HeightToClear(plan.terrain, p_W, below_m); }, guard.RollOf(made));
    swing = std::move(made);
    ++fitted;
  }
  plan.swings = std::move(swings);
  return fitted;
}

}  // namespace gaitwright
