// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/description/mjcf_actuators_internal.h"

namespace gaitwright {

/// Gives joints without an actuator the effort that fixed tendons transmit to them from joints with an actuator, as in
/// a differential. A fixed tendon whose length, the sum of c_j q_j, has a narrow range ties its joints. A tension t
/// acts on each joint with t c_j. A motor of effort u at joint d with n ties can balance t = u / (n |c_d|) in each.
/// Only ties with one joint without an actuator are used; each gives a note.
void DriveMjcfJointsByTendons(MjcfContext& context, const MjcfTree& tree, std::vector<MjcfDrive>& drives);

}  // namespace gaitwright
