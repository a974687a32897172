// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <random>

namespace gaitwright {

/// A random vector of fixed size whose components are drawn in order. The evaluation order of function arguments would
/// depend on the compiler.
template <class Vector, class Distribution>
Vector Drawn(Distribution& distribution, std::mt19937& engine) {
  Vector v;
  for (auto& component : v) component = distribution(engine);
  return v;
}

}  // namespace gaitwright
