// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include "optimisation/numerics/vector_function.h"

/// Problems given by the values of their functions only.
namespace gaitwright::by_values {

using Values = std::vector<double>;
using Function = std::function<Values(const VectorX&)>;

/// The function, with derivatives by differences.
inline VectorFunction Of(const Function& function) {
  return Differenced([function](const VectorX& x, VectorX& value) {
    const Values values = function(x);
    value = Eigen::Map<const VectorX>(values.data(), static_cast<Eigen::Index>(values.size()));
  });
}

inline VectorX Vec(const Values& values) {
  return Eigen::Map<const VectorX>(values.data(), static_cast<Eigen::Index>(values.size()));
}

}  // namespace gaitwright::by_values
