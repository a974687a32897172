// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "kinematics/base/result.h"
#include "kinematics/model/robot_model.h"
#include "planning/paths/base_path.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// How the base gains its speed and loses it: in some cycles of the gait, or as much longer as takes an acceleration.
struct SpeedRamp {
  double cycles = 0.0, acceleration_m_s2 = 0.0;  ///< 0 for any
};

/// Where the base goes and how long it takes.
struct Course {
  PlanarTwist twist;        ///< of the whole course; with counted footfalls, of one footfall
  double duration_s = 0.0;  ///< from the first lift-off until the base stands again
  double ramp_s = 0.0;      ///< in which the base gains its speed, and again loses it
};

/// Why a command makes no sense for any robot: numbers that are not finite or out of range, contradictions.
std::optional<Failure> CheckCommand(const WalkCommand& command);

/// Speed of the command along its direction that is used: given, or the robot's own [m/s].
double CommandedSpeed(const RobotModel& model, const WalkCommand& command);

/// Speeds of a command, per second: those given. The robot's default forward speed is used if no speed is given, or a
/// distance with only a yaw rate.
PlanarTwist CommandedVelocity(const RobotModel& model, const WalkCommand& command);

/// The course of a command at a gait.
///   distance   at the commanded velocity until the path is that long; a yaw rate alone, without a distance, is a
///              quarter turn
///   duration   the commanded velocity for that time, rounded to whole cycles, in which the ramps are contained
///   goal       the twist that leads there, at the speeds given
///   steps      the twist of one footfall: its length, or the commanded velocity for cycle / number of feet
/// @param ramp  of counted footfalls none.
/// Failure kBadInput when it goes nowhere or lasts over 600 s.
Result<Course> MakeCourse(const RobotModel& model, const Gait& gait, const WalkCommand& command, const SpeedRamp& ramp);

/// Lateral speed and yaw rate that suit a forward speed, if the command gives none [m/s, rad/s]; small enough that feet
/// do not collide.
PlanarTwist FittingSpeeds(const RobotModel& model, const Gait& gait, const WalkCommand& command);

}  // namespace gaitwright
