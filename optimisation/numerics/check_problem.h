// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "optimisation/numerics/constrained_problem.h"

namespace gaitwright {

/// The list of variables, or all variables if it is empty. @throws InvalidArgument for a duplicate or unknown variable.
std::vector<int> CheckedVariables(const std::vector<int>& variables, int count);

/// @throws InvalidArgument for a start that is empty or not finite, for bounds of the wrong size or in the wrong order,
/// and for a list with duplicate or unknown variables.
void CheckConstrainedProblem(const ConstrainedProblem& problem);

}  // namespace gaitwright
