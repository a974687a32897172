// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "workflows/walk/walk.h"

namespace gaitwright {

/// Plans parts one after the other for the A1 and plays them with the controller that there is by default; expects a
/// plan of so many parts that passes its audit, where it is that of a rigid body one at rest in the middle of each part
/// that stands still, and every gate to hold.
void ExpectToWalk(const std::string& sequence, std::size_t parts);

}  // namespace gaitwright
