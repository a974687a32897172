// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace gaitwright {

/// Number of calls of malloc, calloc, realloc and similar functions since the start of the program. operator new and
/// Eigen use these functions.
long Allocations();

}  // namespace gaitwright
