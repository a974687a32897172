// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/spatial/pose.h"
#include "optimisation/numerics/constrained_problem.h"

namespace gaitwright {

/// A vector in space that depends on unknown vectors alone, each by one number:
///   constant + sum_i coefficient_i * (x[start_i], x[start_i + 1], x[start_i + 2]).
struct AffineVector {
  /// An unknown vector, by the index of the first of its three numbers, and its factor.
  struct Part {
    int start;
    double coefficient;
  };

  Vector3 constant = Vector3::Zero();
  std::vector<Part> parts = {};  ///< by start, each once

  /// The unknown vector itself.
  static AffineVector Unknown(int start) { return {Vector3::Zero(), {{start, 1.0}}}; }

  /// Its value.
  Vector3 At(const VectorX& x) const;
  AffineVector& operator+=(const AffineVector& other) { return Add(1.0, other); }
  /// Adds factor * other.
  AffineVector& Add(double factor, const AffineVector& other);
  /// Adds `by` * (derivative of this by the unknowns) to three rows of a Jacobian, from `row` on.
  template <typename Derived>
  void AddTo(const Eigen::MatrixBase<Derived>& by, MatrixX& J, Eigen::Index row) const {
    for (const Part& part : parts) J.block(row, part.start, by.rows(), 3) += part.coefficient * by;
  }
};

/// Gathers the unknowns that a term sees, and writes what depends on them in the term's own numbers.
class SeenUnknowns {
 public:
  /// The term's number of unknown `first`; it and the `count` - 1 after it are neighbours there too.
  int See(int first, int count);
  AffineVector See(const AffineVector& vector);
  const std::vector<int>& variables() const { return variables_; }

 private:
  std::vector<int> variables_;
};

/// The rows directions * vector - offsets as a residual or a part of a constraint; directions has size rows x 3.
/// The variables that it sees are returned in `seen`.
VectorFunction AffineRows(const AffineVector& vector, const MatrixX& directions, const VectorX& offsets,
                          SeenUnknowns& seen);

}  // namespace gaitwright
