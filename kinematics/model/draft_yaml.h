// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "kinematics/base/result.h"

namespace gaitwright {

/// A robot.yaml to begin with, for a URDF whose legs or feet cannot be worked out: all limbs by the links at their
/// ends, those that come down lowest as feet, the others as comments, with the joints of each and how low it comes.
/// @param why  the reason that the robot was refused for, which heads it.
/// Where no limb has two joints these are the limbs of one, on which a robot stands and does not walk.
/// @return the text; empty for a URDF in which no joint moves, or that is none.
std::string DraftRobotYaml(const std::string& urdf_text, const Failure& why);

/// Whether a robot was refused for what a robot.yaml can tell.
bool WantsRobotYaml(const Failure& failure);

}  // namespace gaitwright
