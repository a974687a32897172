// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "kinematics/base/result.h"
#include "kinematics/model/robot_model.h"
#include "planning/paths/base_path.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// Acceleration of the base: a smallest number of gait cycles, and a largest acceleration.
struct SpeedRamp {
  double cycles = 0.0, acceleration_m_s2 = 0.0;  ///< 0 sets no limit
};

/// Path and duration of the base's motion.
struct Course {
  PlanarTwist twist;        ///< of the whole course; for counted footfalls, of one footfall
  double duration_s = 0.0;  ///< from the first lift-off until the base stands again
  double ramp_s = 0.0;      ///< duration of the acceleration, and of the deceleration
};

/// Failure for a command that is invalid for every robot: numbers that are not finite or out of range, contradictions.
std::optional<Failure> CheckCommand(const WalkCommand& command);

/// Size of the forward speed of the command: the given one, or the robot's default [m/s].
double CommandedSpeed(const RobotModel& model, const WalkCommand& command);

/// Forward speed for which the cycle of a gait is fitted, so that steps are as wide for the legs as those of the
/// command [m/s]. Sideways, two legs spread by a whole stride, because feet do not pass each other; forward, by half of
/// one.
double SpeedOfSteps(const RobotModel& model, const WalkCommand& command);

/// The velocity of a command, per second. The robot's default forward speed is used if no speed is given, or for a
/// distance with only a yaw rate.
PlanarTwist CommandedVelocity(const RobotModel& model, const WalkCommand& command);

/// Whether a command gives the number of footfalls.
bool IsCounted(const WalkCommand& command);

/// The course of a command with a gait.
///   distance   at the commanded velocity until the path has this length; a yaw rate without a distance gives a turn of
///              90 degrees
///   duration   the commanded velocity for this time, rounded to whole cycles, including the ramps
///   goal       the twist to the goal, at the given speeds; with steps, that share of it for each footfall
///   steps      the twist of one footfall: its length, or the commanded velocity for cycle / number of feet
/// @param ramp  not used for counted footfalls.
/// Failure kBadInput for a course without motion, or of more than 600 s.
Result<Course> MakeCourse(const RobotModel& model, const Gait& gait, const WalkCommand& command, const SpeedRamp& ramp);

/// Lateral speed and yaw rate that suit the forward speed, if the command gives none [m/s, rad/s]. They are small
/// enough that feet do not collide.
PlanarTwist FittingSpeeds(const RobotModel& model, const Gait& gait, const WalkCommand& command);

}  // namespace gaitwright
