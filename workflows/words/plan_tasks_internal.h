// SPDX-License-Identifier: BSD-3-Clause
// Data and functions that the parts of PlanTasks share.
#pragma once

#include <functional>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "planning/tasks/repertoire.h"
#include "workflows/words/plan_tasks.h"

namespace gaitwright::tasks {

constexpr double kStay = 1.0;  // [s] default time of standing or holding a posture
constexpr double kDegree = std::numbers::pi / 180.0;

/// State of the robot at the end of a task, from which the next one starts.
struct Stance {
  enum class Pose { kStanding, kSitting, kLying, kCrouching };

  PostureKey key;
  Pose pose = Pose::kStanding;
};

/// A motion as a function of a size, such as the depth of a squat.
using MotionBySize = std::function<Result<PostureMotion>(double size)>;

/// Sizes to try, the best one first.
struct Sizes {
  std::vector<double> tried;
  bool asked = false;  ///< the first size was requested, so no other is tried
  std::string name;    ///< "depth_m", for messages
};

/// The failure of a motion that fails its audit: the worst violation.
Failure ReasonBroken(const std::string& what, const AuditReport& audit);

/// The largest feasible size below an infeasible one, to a thirtieth of it; 0 if there is none.
double LargestBelow(const std::function<bool(double size)>& is_feasible, double size);

/// A posture motion that passes its audit: the first size that is feasible at some speed, at the highest such speed.
/// Failures as of PlanTasks.
Result<PostureMotion> PostureWithin(const RobotModel& model, const MotionBySize& motion, const Sizes& sizes,
                                    const MotionOptions& options);

/// Smallest number of steps of a walk: the last one brings the feet together.
inline constexpr int kFewestSteps = 2;

/// The walk that a task requests, without its place.
Result<WalkRequest> WalkRequestOf(const RobotModel& model, const Task& task, const TaskOptions& options);

/// A jump: where the base goes in plan view, and how far it turns during it.
struct Jump {
  Vector2 displacement_m = Vector2::Zero();
  double turn_rad = 0.0;
};

/// The leap, or the fewest leaps, of a jump, by the robot's gait for leaps (LeapGait).
WalkRequest JumpRequestOf(const RobotModel& model, const Jump& jump, const TaskOptions& options);

/// The robot with other standing positions of the joints outside the legs.
RobotModel Posed(RobotModel model, const VectorX& joints);

/// Appends a time at rest in the final posture to a motion.
void StayOn(double duration_s, MotionPlan& plan);

}  // namespace gaitwright::tasks
