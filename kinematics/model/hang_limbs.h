// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// Lets the arms of a robot on two legs hang. A revolute joint that belongs to no leg goes to the angle at which the
/// limb beyond it hangs lowest, if this angle is within its limits. Upright parts such as a head, whose lowest angle is
/// beyond their limits, stay at zero. Then each limb is rotated 0.4 rad away from the body, so that it does not touch
/// the legs. Other robots keep their limbs at zero, because an arm that hangs from a quadruped would touch the ground.
/// @param given  joint positions by coordinate that are kept; NaN for the others.
/// @param joints  positions of the posture, size n; changed in place.
/// @return one line of text for each limb.
std::vector<std::string> HangLimbs(const RobotModel& model, const VectorX& given, VectorX& joints);

}  // namespace gaitwright
