// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "kinematics/base/result.h"

namespace gaitwright {

/// Checks a URDF before urdfdom reads it, because urdfdom ignores many errors. The errors are: not XML; another root
/// element; names that are missing, duplicate or unknown; a link with two parents (a loop); several roots or a detached
/// cycle; numbers that are not finite or far too large; a negative mass; a zero axis; a missing or inverted limit; a
/// mimic of an unknown or fixed joint, of itself, in a cycle or with multiplier 0; an unsupported joint type; a size
/// that is not positive; a mesh without a file.
/// @param strict  a non-physical inertia, an inertia without mass and a position range of 0 to 0 are refused too.
/// @return the first error, with the element, or nothing.
std::optional<Failure> CheckUrdf(const std::string& urdf_text, bool strict = false);

}  // namespace gaitwright
