// SPDX-License-Identifier: BSD-3-Clause
#include <cstddef>

#include "optimisation/numerics/variable_blocks_internal.h"

namespace gaitwright {

std::vector<VariableBlock> BlocksOf(const std::vector<const std::vector<int>*>& seen, int count) {
  std::vector<std::vector<std::size_t>> seen_by(static_cast<std::size_t>(count));
  for (std::size_t t = 0; t < seen.size(); ++t) {
    if (static_cast<int>(seen[t]->size()) == count) continue;
    for (const int v : *seen[t]) seen_by[static_cast<std::size_t>(v)].push_back(t);
  }
  std::vector<VariableBlock> blocks;
  for (int v = 0; v < count; ++v) {
    const auto i = static_cast<std::size_t>(v);
    if (v > 0 && seen_by[i] == seen_by[i - 1]) {
      ++blocks.back().size;
    } else {
      blocks.push_back({v, 1});
    }
  }
  return blocks;
}

}  // namespace gaitwright
