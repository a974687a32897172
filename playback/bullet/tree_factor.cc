// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "playback/bullet/tree_factor_internal.h"

namespace gaitwright::bullet {

CoordinateTree::CoordinateTree(const std::vector<int>& parent) {
  for (std::size_t i = 0; i < parent.size(); ++i) {
    const std::size_t at = path_.size();
    int depth = 0;
    if (parent[i] >= 0) {
      const auto p = static_cast<std::size_t>(parent[i]);
      depth = depth_[p] + 1;
      for (int a = 0; a < depth; ++a) path_.push_back(path_[offset_[p] + static_cast<std::size_t>(a)]);
    }
    path_.push_back(static_cast<int>(i));
    depth_.push_back(depth);
    offset_.push_back(at);
  }
}

void Multiply(const CoordinateTree& tree, const std::vector<double>& M, const double* x, double* out) {
  for (int i = 0; i < tree.size(); ++i) {
    const double* row = &M[tree.offset(i)];
    const int* path = tree.path(i);
    const int depth = tree.depth(i);
    out[i] = row[depth] * x[i];
    for (int a = 0; a < depth; ++a) {
      out[i] += row[a] * x[path[a]];
      out[path[a]] += row[a] * x[i];
    }
  }
}

void TreeFactor::Compute(const std::vector<double>& M) {
  L_ = M;
  for (int i = tree_.size() - 1; i >= 0; --i) {
    double* row = &L_[tree_.offset(i)];
    const int* path = tree_.path(i);
    const int depth = tree_.depth(i);
    const double inverse = 1.0 / std::sqrt(row[depth]);
    row[depth] = inverse;
    for (int a = 0; a < depth; ++a) row[a] *= inverse;
    for (int a = 0; a < depth; ++a) {
      double* above = &L_[tree_.offset(path[a])];
      const double share = row[a];
      for (int b = 0; b <= a; ++b) above[b] -= share * row[b];
    }
  }
}

void TreeFactor::SolveUpper(double* x) const {
  for (int i = tree_.size() - 1; i >= 0; --i) {
    if (x[i] == 0.0) continue;
    const double* row = &L_[tree_.offset(i)];
    const int* path = tree_.path(i);
    const int depth = tree_.depth(i);
    x[i] *= row[depth];
    for (int a = 0; a < depth; ++a) x[path[a]] -= row[a] * x[i];
  }
}

void TreeFactor::SolveUpperAlong(int coordinate, double* x) const {
  const int* path = tree_.path(coordinate);
  for (int a = tree_.depth(coordinate); a >= 0; --a) {
    const double* row = &L_[tree_.offset(path[a])];
    const double value = x[a] *= row[a];
    for (int b = 0; b < a; ++b) x[b] -= row[b] * value;
  }
}

void TreeFactor::SolveLower(double* x) const {
  for (int i = 0; i < tree_.size(); ++i) {
    const double* row = &L_[tree_.offset(i)];
    const int* path = tree_.path(i);
    const int depth = tree_.depth(i);
    for (int a = 0; a < depth; ++a) x[i] -= row[a] * x[path[a]];
    x[i] *= row[depth];
  }
}

}  // namespace gaitwright::bullet
