// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/model/robot_yaml.h"

namespace gaitwright {

/// Puts the limits of a robot.yaml in place of the URDF's. All functions here throw InvalidArgument with the line and
/// the name of the offender: no such joint (names the nearest), a joint that mimics another, keys of a sliding joint
/// for a turning one and the reverse, values that contradict each other.
void ApplyLimits(const RobotYaml& yaml, RobotModel& model);

/// Rotates the base frame if x does not point forward in the root link or z not up, according to the file or the
/// derived axes.
void ApplyAxes(const RobotYaml& yaml, RobotModel& model);

/// Puts in the motors, those without words in the file included, and what joints take of themselves.
void ApplyMotors(const RobotYaml& yaml, RobotModel& model);

/// Standing positions by coordinate; NaN if not given. Refuses one outside its joint's limits.
VectorX GivenPosture(const RobotYaml& yaml, const RobotModel& model);

/// Puts in gains, own speed and base height. Refuses a height that is not the one of the standing posture, and a
/// posture from the file in which a foot is more than 5 mm above the lowest, naming it and by how much.
void ApplyStanding(const RobotYaml& yaml, RobotModel& model);

/// Adds the links that the robot may lie on behind the feet of its legs. Refuses one that is not there, has no flat
/// bottom, or is that of a foot.
void ApplyRests(const RobotYaml& yaml, RobotModel& model);

/// One line of text for each derived quantity, with its source.
std::vector<std::string> DerivationNotes(const RobotYaml& yaml, const RobotModel& model);

}  // namespace gaitwright
