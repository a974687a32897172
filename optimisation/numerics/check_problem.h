// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "optimisation/numerics/constrained_problem.h"

namespace gaitwright {

/// The list of variables as given, or all. @throws InvalidArgument for one named twice or that there is not.
std::vector<int> CheckedVariables(const std::vector<int>& variables, int count);

/// @throws InvalidArgument for a start that is empty or not finite, for intervals of the wrong size or with their ends
/// swapped, and for a list of variables that names one twice or one that there is not.
void CheckConstrainedProblem(const ConstrainedProblem& problem);

}  // namespace gaitwright
