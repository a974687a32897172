// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace gaitwright::bullet {

/// A tree of coordinates, each with its path from the root. A symmetric matrix over the tree has entries only where one
/// coordinate is on the path of the other. Only the lower half is stored, row by row, each row along its path: entry
/// (i, path(i)[a]) has index offset(i) + a. A coordinate has the same a on every path that contains it.
class CoordinateTree {
 public:
  /// @param parent  by coordinate: the previous coordinate on its path, with a lower index; -1 for the root.
  explicit CoordinateTree(const std::vector<int>& parent);

  int size() const { return static_cast<int>(depth_.size()); }
  /// Number of stored entries of a matrix.
  std::size_t entries() const { return path_.size(); }
  int depth(int i) const { return depth_[static_cast<std::size_t>(i)]; }
  std::size_t offset(int i) const { return offset_[static_cast<std::size_t>(i)]; }
  /// Path from the root to i itself, of depth(i) + 1 coordinates.
  const int* path(int i) const { return &path_[offset(i)]; }

 private:
  std::vector<int> depth_, path_;
  std::vector<std::size_t> offset_;
};

/// out = M x, with M stored as CoordinateTree describes. @param x, out  size of the tree.
void Multiply(const CoordinateTree& tree, const std::vector<double>& M, const double* x, double* out);

/// The factor L of a positive definite M = L^T L over a tree. Elimination goes from the leaves to the root, so that L
/// has the zeros of M, and the cost of factor and solves depends on the lengths of the paths. Featherstone, Rigid Body
/// Dynamics Algorithms, 2008, section 6.5.
class TreeFactor {
 public:
  /// The tree must outlive the factor.
  explicit TreeFactor(const CoordinateTree& tree) : tree_(tree), L_(tree.entries(), 0.0) {}

  void Compute(const std::vector<double>& M);
  /// x := L^-T x; entries stay zero except on the paths of non-zero entries. SolveLower then gives M^-1 x. The product
  /// of two such halves is x1^T M^-1 x2.
  void SolveUpper(double* x) const;
  /// SolveUpper for an x that is zero off the path of a coordinate. @param x  along the path, depth + 1 numbers.
  void SolveUpperAlong(int coordinate, double* x) const;
  /// x := L^-1 x
  void SolveLower(double* x) const;

 private:
  const CoordinateTree& tree_;
  std::vector<double> L_;  ///< its diagonal holds the inverse
};

}  // namespace gaitwright::bullet
