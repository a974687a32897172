// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include "optimisation/numerics/vector_function.h"

namespace gaitwright {

/// Checks that a function's Jacobian is not zero and equals that of central differences.
inline void ExpectDerivative(const VectorFunction& function, const VectorX& x, double tolerance = 1e-6) {
  VectorX value, before, after;
  function(x, value, nullptr);
  MatrixX J = MatrixX::Zero(value.size(), x.size());
  function(x, value, &J);
  EXPECT_GT(J.cwiseAbs().maxCoeff(), 1e-6);
  constexpr double kStep = 1e-6;
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const VectorX step = kStep * VectorX::Unit(x.size(), i);
    function(x - step, before, nullptr);
    function(x + step, after, nullptr);
    const VectorX difference = (after - before) / (2.0 * kStep);
    EXPECT_LT((difference - J.col(i)).cwiseAbs().maxCoeff(), tolerance * (1.0 + difference.cwiseAbs().maxCoeff()))
        << "column " << i << ": " << J.col(i).transpose() << ", by differences " << difference.transpose();
  }
}

}  // namespace gaitwright
