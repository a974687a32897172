// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// The name of a joint without its axis: "left_hip" of "left_hip_pitch_joint" and "lhip" of "LHipPitch", in lower case.
std::string StemOf(const std::string& joint_name);

/// Successive joints of a robot that do the work of one ball joint: one to three.
struct JointRun {
  std::vector<int> dofs;        ///< independent coordinates, base first
  std::vector<Vector3> axes;    ///< at zero positions, in the axes of the base
  Vector3 p = Vector3::Zero();  ///< of the first joint at zero positions, in the base's frame
};

/// The run of joints with these independent coordinates.
JointRun RunOf(const RobotModel& model, const std::vector<int>& dofs);

/// All independent joints in the order of the description, successive hinges of one stem together, at most three.
std::vector<std::vector<int>> StemRuns(const RobotModel& model);

/// The coordinates that each joint of a skeleton moves: those of the robot's joint of its name (the ending "_joint" and
/// capitals do not count) and of the hinges of the same stem after it that no joint of the skeleton has; or those of a
/// run whose stem is its name. Empty for a joint without a partner. @throws InvalidArgument if two joints have one
/// partner.
std::vector<std::vector<int>> PartnersOf(const RobotModel& model, const std::vector<std::string>& skeleton);

}  // namespace gaitwright
