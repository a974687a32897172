// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "kinematics/base/result.h"

namespace gaitwright {

/// Draft of a robot.yaml for a URDF whose legs or feet cannot be derived. It lists all limbs by the links at their
/// ends, with the joints and the lowest height of each. The lowest limbs are feet, and the others are comments. If no
/// limb has two joints, limbs of one joint are listed; a robot can stand on them but not walk.
/// @param why  the reason of the refusal, for the head of the draft.
/// @return the text; empty for an invalid URDF or one without moving joints.
std::string DraftRobotYaml(const std::string& urdf_text, const Failure& why);

/// Whether the missing data of a refusal can be given in a robot.yaml.
bool WantsRobotYaml(const Failure& failure);

}  // namespace gaitwright
