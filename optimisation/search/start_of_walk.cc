// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/search/start_of_walk.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "planning/footsteps/course.h"
#include "planning/footsteps/uneven_footsteps.h"

namespace gaitwright {
namespace {

using Extent = WalkCommand::Extent;

constexpr double kCycles = 4.0;  // one to accelerate, one to stop, and two in between at full speed
constexpr double kShort = 1.5;   // times as long as the start

}  // namespace

WalkCommand StartOfWalk(const RobotModel& model, const WalkCommand& command, const Gait& gait) {
  const double cycle_s = gait.cycle_s;
  WalkCommand c = command;
  const PlanarTwist velocity = CommandedVelocity(model, command);
  const double speed = std::hypot(velocity.x_m, velocity.y_m);
  if (speed > 0.0) c.distance_m = std::min(c.distance_m, kCycles * cycle_s * speed);
  c.duration_s = std::min(c.duration_s, kCycles * cycle_s);
  const bool turns = c.extent == Extent::kDistance && speed == 0.0;
  if (turns && 0.5 * std::numbers::pi > kCycles * cycle_s * std::abs(velocity.yaw_rad)) {
    c.extent = Extent::kDuration;
    c.duration_s = kCycles * cycle_s;
  }
  c.steps = std::min(c.steps, static_cast<int>(kCycles * static_cast<double>(model.feet.size())));
  if (c.extent != Extent::kGoal) return c;
  const Result<Course> course = MakeCourse(model, gait, command, {});
  if (course && course->duration_s > kCycles * cycle_s) {
    const double most = IsCounted(command) ? StepsOfBase(gait, c.steps) : kCycles * cycle_s / course->duration_s;
    const PlanarPose near = PoseAlong(course->twist, most);
    c.goal_x_m = near.x_m;
    c.goal_y_m = near.y_m;
    c.goal_yaw_rad = near.yaw_rad;
  }
  return c;
}

bool IsShort(const RobotModel& model, const WalkCommand& command, const Gait& gait) {
  const Result<Course> whole = MakeCourse(model, gait, command, {});
  const Result<Course> start = MakeCourse(model, gait, StartOfWalk(model, command, gait), {});
  return whole && start && whole->duration_s <= kShort * start->duration_s;
}

}  // namespace gaitwright
