// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/model/robot_yaml.h"

namespace gaitwright {

/// Replaces the limits of the URDF by those of a robot.yaml. All functions here throw InvalidArgument with the line and
/// the name of the offender: an unknown joint (with the nearest name), a joint that mimics another one, keys of a
/// prismatic joint for a revolute one or the reverse, values that contradict each other.
void ApplyLimits(const RobotYaml& yaml, RobotModel& model);

/// Rotates the base frame so that x points forward and z up, if the axes of the root link do not. The axes are those of
/// the file, or derived.
void ApplyAxes(const RobotYaml& yaml, RobotModel& model);

/// Sets the motors of all joints, also of those that the file does not mention, and the losses of the joints.
void ApplyMotors(const RobotYaml& yaml, RobotModel& model);

/// Standing positions by coordinate; NaN if not given. Refuses a position outside the limits of its joint.
VectorX GivenPosture(const RobotYaml& yaml, const RobotModel& model);

/// Sets gains, default speed and base height. Refuses a base height that does not match the standing posture. Refuses a
/// posture from the file in which a foot is more than 5 mm above the lowest one; the message names the foot and its
/// height.
void ApplyStanding(const RobotYaml& yaml, RobotModel& model);

/// Appends the links that the robot may lie on to the feet of its legs. Refuses a link that does not exist, has no flat
/// bottom, or is a foot.
void ApplyRests(const RobotYaml& yaml, RobotModel& model);

/// One line of text for each derived quantity, with its source.
std::vector<std::string> DerivationNotes(const RobotYaml& yaml, const RobotModel& model);

}  // namespace gaitwright
