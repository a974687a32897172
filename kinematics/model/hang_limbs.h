// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// Lets the arms of a robot on two legs hang. A revolute joint that belongs to no leg goes to the angle at which the
/// limb beyond it hangs lowest, if that is within its limits; upright parts such as a head, whose lowest angle is
/// beyond their limits, stay at zero. Then each limb is turned 0.4 rad away from the body, so that it does not brush
/// the legs. Other robots keep their limbs at zero: an arm that hangs from a quadruped meets the ground.
/// @param given joint positions by coordinate that are kept; NaN for the others.
/// @param joints of the posture, size n; changed in place.
/// @return one line of text for each limb.
std::vector<std::string> HangLimbs(const RobotModel& model, const VectorX& given, VectorX& joints);

}  // namespace gaitwright
