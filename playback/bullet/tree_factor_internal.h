// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace gaitwright::bullet {

/// A tree of coordinates, each with its path from the root. Symmetric matrices over it have entries only where one
/// coordinate is on the path of the other. Of those the lower half is kept, row after row, each row along its path:
/// entry (i, path(i)[a]) is number offset(i) + a, and a coordinate has the same a on every path that it is on.
class CoordinateTree {
 public:
  /// @param parent  by coordinate: the one before it on its path, lower than itself; -1 for the root.
  explicit CoordinateTree(const std::vector<int>& parent);

  int size() const { return static_cast<int>(depth_.size()); }
  /// Number of entries that a matrix has.
  std::size_t entries() const { return path_.size(); }
  int depth(int i) const { return depth_[static_cast<std::size_t>(i)]; }
  std::size_t offset(int i) const { return offset_[static_cast<std::size_t>(i)]; }
  /// From the root to i itself; depth(i) + 1 of them.
  const int* path(int i) const { return &path_[offset(i)]; }

 private:
  std::vector<int> depth_, path_;
  std::vector<std::size_t> offset_;
};

/// out = M x, with M as CoordinateTree has it. @param x, out  size of the tree.
void Multiply(const CoordinateTree& tree, const std::vector<double>& M, const double* x, double* out);

/// The factor L of a positive definite M = L^T L over a tree. Eliminated from the leaves to the root, L is zero where M
/// is, so that factor and solves cost what the paths are long. Featherstone, Rigid Body Dynamics Algorithms, 2008,
/// section 6.5.
class TreeFactor {
 public:
  /// The tree must outlive it.
  explicit TreeFactor(const CoordinateTree& tree) : tree_(tree), L_(tree.entries(), 0.0) {}

  void Compute(const std::vector<double>& M);
  /// x := L^-T x, which leaves zeros but on the paths of what is not zero. M^-1 x is SolveLower of it, and
  /// x1^T M^-1 x2 the product of two such halves.
  void SolveUpper(double* x) const;
  /// SolveUpper for what is zero off the path of a coordinate. @param x  along it, depth + 1 numbers.
  void SolveUpperAlong(int coordinate, double* x) const;
  /// x := L^-1 x
  void SolveLower(double* x) const;

 private:
  const CoordinateTree& tree_;
  std::vector<double> L_;  ///< on the diagonal its inverse
};

}  // namespace gaitwright::bullet
