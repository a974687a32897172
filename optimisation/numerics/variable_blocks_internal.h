// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace gaitwright {

/// Neighbouring variables that occur in the same terms.
struct VariableBlock {
  int start, size;
};

/// The coarsest blocks of neighbouring variables such that each term depends on all of a block or on nothing of it.
/// @param seen   by term: the variables on which it depends. Terms of all variables do not divide blocks.
/// @param count  number of variables.
std::vector<VariableBlock> BlocksOf(const std::vector<const std::vector<int>*>& seen, int count);

}  // namespace gaitwright
