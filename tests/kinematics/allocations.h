// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace gaitwright {

/// Calls of malloc, calloc, realloc and what else gives memory since the program began; operator new and Eigen end
/// there.
long Allocations();

}  // namespace gaitwright
