// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <numbers>

#include "optimisation/pipeline/robot_body.h"
#include "planning/footsteps/course.h"
#include "workflows/words/plan_tasks_internal.h"

namespace gaitwright::tasks {
namespace {

using Extent = WalkCommand::Extent;

constexpr double kFarByDefault = 3.0;  // leg lengths
constexpr double kSideways = 0.4;      // share of the forward speed
constexpr double kSlow = 0.5, kFast = 1.5;
constexpr double kLowBody = 0.88;  // share of the standing height of the centre of mass

double SpeedOf(const RobotModel& model, const Task& task) {
  const double own = model.nominal_speed_m_s;
  const bool sideways = task.Word("direction") == "left" || task.Word("direction") == "right";
  double speed = task.Number("speed_m_s", sideways ? kSideways * own : own);
  if (task.Word("pace") == "slow") speed *= kSlow;
  if (task.Word("pace") == "fast") speed *= kFast;
  return speed;
}

/// Sets a walk of a distance in a direction of the body.
void SetDistance(const std::string& direction, double distance_m, double speed_m_s, WalkCommand& c) {
  if (direction == "backward") {
    c.extent = Extent::kGoal;
    c.goal_x_m = -distance_m;
    c.speed_m_s = speed_m_s;
    return;
  }
  c.extent = Extent::kDistance;
  c.distance_m = distance_m;
  if (direction == "forward") c.speed_m_s = speed_m_s;
  if (direction == "left") c.lateral_speed_m_s = speed_m_s;
  if (direction == "right") c.lateral_speed_m_s = -speed_m_s;
}

/// Sets a number of footfalls; with more than two legs, each step is a footfall of every leg.
void SetSteps(const RobotModel& model, const Task& task, double speed_m_s, WalkCommand& c) {
  const int feet = static_cast<int>(model.feet.size()), steps = task.Count("steps", 1);
  c.extent = Extent::kSteps;
  c.steps = (feet == 2 ? 1 : feet) * std::max(kFewestSteps, steps);
  const std::string direction = task.Word("direction");
  const double share = feet == 2 ? 1.0 : 1.0 / feet;
  if (direction == "forward" && !task.Has("step_length_m")) c.speed_m_s = speed_m_s;
  if (direction == "left") c.lateral_speed_m_s = speed_m_s;
  if (direction == "right") c.lateral_speed_m_s = -speed_m_s;
  constexpr double kStep = 0.2;  // leg lengths, for a step backward
  if (direction == "forward" && task.Has("step_length_m")) c.step_length_m = share * task.Number("step_length_m", 0.0);
  if (direction == "backward") c.step_length_m = -share * task.Number("step_length_m", kStep * model.leg_length_m());
}

}  // namespace

Result<WalkRequest> WalkRequestOf(const RobotModel& model, const Task& task, const TaskOptions& options) {
  WalkRequest request;
  request.motion = options.motion;
  request.motion.pipeline.end_as_standing = true;
  request.seed = options.seed;
  request.gait = task.Word("gait");
  request.own_pace = !task.Has("speed_m_s") && !task.Has("pace") && !task.Has("step_length_m");
  WalkCommand& c = request.command;
  if (task.action == "turn") {
    const double angle_rad = task.Number("angle_deg", 90.0) * std::numbers::pi / 180.0;
    c.extent = Extent::kGoal;
    c.goal_yaw_rad = task.Word("direction") == "left" ? angle_rad : -angle_rad;
    return request;
  }
  const double speed_m_s = SpeedOf(model, task);
  if (task.Word("height") == "low") {
    request.motion.pipeline.com_height_m = kLowBody * StandingCentreOfMass(model).z();
  }
  if (task.Has("steps")) {
    SetSteps(model, task, speed_m_s, c);
    return request;
  }
  double distance_m = task.Number("distance_m", kFarByDefault * model.leg_length_m());
  if (task.Has("duration_s")) distance_m = speed_m_s * task.Number("duration_s", 0.0);
  SetDistance(task.Word("direction"), distance_m, speed_m_s, c);
  return request;
}

}  // namespace gaitwright::tasks
