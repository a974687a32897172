// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <random>

namespace gaitwright {

/// A vector of fixed size whose components are drawn one after the other; arguments of a call are drawn in an order
/// that each compiler chooses.
template <class Vector, class Distribution>
Vector Drawn(Distribution& distribution, std::mt19937& engine) {
  Vector v;
  for (auto& component : v) component = distribution(engine);
  return v;
}

}  // namespace gaitwright
