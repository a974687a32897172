// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "kinematics/base/result.h"

namespace gaitwright {

/// Draft of a robot.yaml for a URDF whose legs or feet cannot be derived: all limbs by the links at their ends, those
/// that come down lowest as feet, the others as comments, with the joints of each and how low it comes.
/// @param why  the reason of the refusal, for the head of the draft. If no limb has two joints, limbs of one joint are
/// listed, on which a robot can stand but not walk.
/// @return the text; empty for a URDF without moving joints, or an invalid one.
std::string DraftRobotYaml(const std::string& urdf_text, const Failure& why);

/// Whether the missing data of a refusal can be given in a robot.yaml.
bool WantsRobotYaml(const Failure& failure);

}  // namespace gaitwright
