// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <random>
#include <vector>

#include "optimisation/centroidal/rigid_body_unknowns.h"
#include "optimisation/numerics/constrained_problem.h"

/// Rows of a rigid body's problem at random unknowns.
namespace gaitwright {

/// Random unknowns of realistic size.
inline VectorX Random(const RigidBodyUnknowns& unknowns, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> draw(-0.3, 0.3);
  VectorX x(unknowns.size());
  for (Eigen::Index i = 0; i < x.size(); ++i) x[i] = draw(random);
  return x;
}

inline VectorX Own(const std::vector<int>& variables, const VectorX& x) {
  VectorX own(static_cast<Eigen::Index>(variables.size()));
  for (std::size_t i = 0; i < variables.size(); ++i) own[static_cast<Eigen::Index>(i)] = x[variables[i]];
  return own;
}

inline VectorX ValueOf(const Constraint& rows, const VectorX& x) {
  VectorX value;
  rows.function(Own(rows.variables, x), value, nullptr);
  return value;
}

}  // namespace gaitwright
