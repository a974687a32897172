// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/spatial/pose.h"
#include "optimisation/numerics/constrained_problem.h"

namespace gaitwright {

/// An affine function of three-dimensional unknown vectors with scalar coefficients:
///   constant + sum_i coefficient_i * (x[start_i], x[start_i + 1], x[start_i + 2]).
struct AffineVector {
  /// An unknown vector (index of its first component) and its coefficient.
  struct Part {
    int start;
    double coefficient;
  };

  Vector3 constant = Vector3::Zero();
  std::vector<Part> parts = {};  ///< sorted by start, without duplicates

  /// The function that equals the unknown vector.
  static AffineVector Unknown(int start) { return {Vector3::Zero(), {{start, 1.0}}}; }

  /// Value for the unknowns x.
  Vector3 At(const VectorX& x) const;
  AffineVector& operator+=(const AffineVector& other) { return Add(1.0, other); }
  /// Adds factor * other.
  AffineVector& Add(double factor, const AffineVector& other);
  /// Adds `by` * (derivative of this vector with respect to the unknowns) to three rows of a Jacobian, from `row` on.
  template <typename Derived>
  void AddTo(const Eigen::MatrixBase<Derived>& by, MatrixX& J, Eigen::Index row) const {
    for (const Part& part : parts) J.block(row, part.start, by.rows(), 3) += part.coefficient * by;
  }
};

/// Collects the unknowns that a term depends on, and assigns local indices to them.
class SeenUnknowns {
 public:
  /// Local index of unknown `first`; the `count` - 1 unknowns after it get the following local indices.
  int See(int first, int count);
  AffineVector See(const AffineVector& vector);
  const std::vector<int>& variables() const { return variables_; }

 private:
  std::vector<int> variables_;
};

/// The rows directions * vector - offsets as a residual or a part of a constraint; directions has size rows x 3. The
/// variables on which they depend are returned in `seen`.
VectorFunction AffineRows(const AffineVector& vector, const MatrixX& directions, const VectorX& offsets,
                          SeenUnknowns& seen);

}  // namespace gaitwright
