// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/description/mjcf_actuators_internal.h"

namespace gaitwright {

/// Gives joints without an actuator the effort that fixed tendons carry to them from joints that have one, as in a
/// differential: a fixed tendon whose length, the sum of c_j q_j, is held in a narrow range ties its joints, and a
/// tension t in it acts on each by t c_j. A motor of effort u at joint d that n ties share can bear t = u / (n |c_d|).
/// Ties of one joint without an actuator are taken; each is noted.
void DriveMjcfJointsByTendons(MjcfContext& context, const MjcfTree& tree, std::vector<MjcfDrive>& drives);

}  // namespace gaitwright
