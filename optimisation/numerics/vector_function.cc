// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/numerics/vector_function.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gaitwright {

VectorFunction Differenced(std::function<void(const VectorX& x, VectorX& value)> function) {
  return [function = std::move(function)](const VectorX& x, VectorX& value, MatrixX* J) {
    function(x, value);
    if (J == nullptr) return;
    VectorX moved = x, above = value, below = value;
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      const double step = 6e-6 * std::max(1.0, std::abs(x[i]));
      moved[i] = x[i] + step;
      function(moved, above);
      moved[i] = x[i] - step;
      function(moved, below);
      moved[i] = x[i];
      J->col(i) = (above - below) / (2.0 * step);
    }
  };
}

}  // namespace gaitwright
