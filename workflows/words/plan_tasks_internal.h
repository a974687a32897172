// SPDX-License-Identifier: BSD-3-Clause
// What the parts of PlanTasks share.
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

constexpr double kStay = 1.0;  // [s] for which it stands, or holds a posture, where no words say how long
constexpr double kDegree = std::numbers::pi / 180.0;

/// How a robot is left by a task: what the next one begins with.
struct Stance {
  enum class Pose { kStanding, kSitting, kLying, kCrouching };

  PostureKey key;
  Pose pose = Pose::kStanding;
};

/// A motion by a size, such as how deep a squat goes.
using MotionBySize = std::function<Result<PostureMotion>(double size)>;

/// Sizes to try, the best one first.
struct Sizes {
  std::vector<double> tried;
  bool asked = false;  ///< the first was asked for: no other serves
  std::string name;    ///< "depth_m", for messages
};

/// Why a motion cannot be, by an audit that it does not pass: its worst law.
Failure WhyBroken(const std::string& what, const AuditReport& audit);

/// The largest size below one that does not serve, to a thirtieth of that; 0 for none.
double LargestBelow(const std::function<bool(double size)>& serves, double size);

/// A posture motion that passes its audit: of the first size that any stretch lets pass, stretched as far as it has to
/// be. Failures as of PlanTasks.
Result<PostureMotion> PostureWithin(const RobotModel& model, const MotionBySize& motion, const Sizes& sizes,
                                    const MotionOptions& options);

/// The walk that a task asks for, its place left out.
Result<WalkRequest> WalkRequestOf(const RobotModel& model, const Task& task, const TaskOptions& options);

/// The robot with its joints outside the legs elsewhere in standing.
RobotModel Posed(RobotModel model, const VectorX& joints);

/// Adds to a motion that it stays as it ends.
void StayOn(double duration_s, MotionPlan& plan);

}  // namespace gaitwright::tasks
