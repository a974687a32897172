// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "kinematics/base/result.h"

namespace gaitwright {

/// Reads a URDF for what is wrong with it before urdfdom, which passes over much, sees it: not XML, another root
/// element, names that are missing, double or unknown, a link with two parents (a loop), several roots or a detached
/// cycle, numbers that are not finite or absurd, a negative mass, a zero axis, a missing or inverted limit, a mimic of
/// an unknown or fixed joint, of itself, in a circle or with multiplier 0, an unsupported joint type, a size that is
/// not positive, a mesh without a file.
/// @param strict  an inertia that no body has is refused too; else it is mended later.
/// @return the first thing wrong, naming the offender, or nothing.
std::optional<Failure> CheckUrdf(const std::string& urdf_text, bool strict = false);

}  // namespace gaitwright
