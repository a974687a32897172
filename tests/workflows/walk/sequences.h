// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "workflows/walk/walk.h"

namespace gaitwright {

/// Plans parts in sequence for the A1 and plays them with the default controller. Expects a plan with this number of
/// parts that passes its audit, all gates passed, and, for rigid-body plans, rest in the middle of each part that
/// stands still.
void ExpectToWalk(const std::string& sequence, std::size_t parts);

}  // namespace gaitwright
