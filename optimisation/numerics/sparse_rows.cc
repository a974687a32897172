// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/numerics/sparse_rows.h"

#include <algorithm>
#include <numeric>

namespace gaitwright {

SparseRows::SparseRows(const ConstrainedProblem& problem) : size_(problem.start.size()) {
  for (const Residual& r : problem.residuals) Add(r.function, r.variables, r.affine, problem.start, nullptr);
  residual_rows_ = static_cast<Eigen::Index>(owner_.size());
  for (const Constraint& c : problem.constraints) Add(c.function, c.variables, c.affine, problem.start, &c);
  value_.setZero(static_cast<Eigen::Index>(owner_.size()));
  FindPattern();
}

void SparseRows::Add(const VectorFunction& function, const std::vector<int>& variables, bool affine,
                     const VectorX& start, const Constraint* owner) {
  Term term{&function, affine, owner == nullptr, variables, static_cast<Eigen::Index>(owner_.size())};
  if (variables.empty()) {
    term.variables.resize(static_cast<std::size_t>(size_));
    std::iota(term.variables.begin(), term.variables.end(), 0);
  }
  term.x = start(term.variables);
  if (owner != nullptr) term.value.setZero(owner->lower.size());
  function(term.x, term.value, nullptr);
  term.J.setZero(term.value.size(), term.x.size());
  function(term.x, term.value, &term.J);
  owner_.insert(owner_.end(), static_cast<std::size_t>(term.value.size()), owner);
  terms_.push_back(std::move(term));
}

Eigen::Index SparseRows::Slot(int row, int column) const {
  const int* rows = matrix_.innerIndexPtr();
  const int* at = std::lower_bound(rows + matrix_.outerIndexPtr()[column], rows + matrix_.outerIndexPtr()[column + 1],
                                   std::max(row, column));
  return at - rows;
}

void SparseRows::FindPattern() {
  std::vector<Eigen::Triplet<double>> entries;
  for (const Term& term : terms_) {
    for (const int i : term.variables) {
      for (const int j : term.variables) {
        if (i > j) entries.emplace_back(i, j, 0.0);
      }
    }
  }
  for (int i = 0; i < size_; ++i) entries.emplace_back(i, i, 0.0);
  matrix_.resize(size_, size_);
  matrix_.setFromTriplets(entries.begin(), entries.end());
  cholesky_.analyzePattern(matrix_);
  for (int i = 0; i < size_; ++i) diagonal_.push_back(Slot(i, i));
  fixed_.setZero(matrix_.nonZeros());
  for (Term& term : terms_) {
    const std::vector<int>& of = term.variables;
    for (std::size_t b = 0; b < of.size(); ++b) {
      for (std::size_t a = b; a < of.size(); ++a)
        term.slots.push_back(Slot(std::max(of[a], of[b]), std::min(of[a], of[b])));
    }
    if (!term.residual || !term.affine) continue;
    term.weighted = term.J;
    AddSquare(term, fixed_);
  }
}

void SparseRows::AddSquare(const Term& term, VectorX& values) {
  // The term has few rows, so columns are faster than blocks.
  const Eigen::Index count = term.weighted.cols(), rows = term.weighted.rows();
  const Eigen::Index* slot = term.slots.data();
  const double* all = term.weighted.data();
  for (Eigen::Index b = 0; b < count; ++b) {
    const double* right = all + b * rows;
    for (const double* left = right; left != all + count * rows; left += rows) {
      double sum = 0.0;
      for (Eigen::Index row = 0; row < rows; ++row) sum += left[row] * right[row];
      values[*slot++] += sum;
    }
  }
}

void SparseRows::Evaluate(const VectorX& x) {
  for (Term& term : terms_) {
    for (std::size_t i = 0; i < term.variables.size(); ++i) term.x[static_cast<Eigen::Index>(i)] = x[term.variables[i]];
    (*term.function)(term.x, term.value, nullptr);
    value_.segment(term.row, term.value.size()) = term.value;
  }
}

void SparseRows::Differentiate() {
  for (Term& term : terms_) {
    if (term.affine) continue;
    term.J.setZero();
    (*term.function)(term.x, term.value, &term.J);
  }
}

VectorX SparseRows::Gradient(const VectorX& by) const {
  VectorX gradient = VectorX::Zero(size_);
  for (const Term& term : terms_) {
    const auto own = by.segment(term.row, term.value.size());
    for (std::size_t i = 0; i < term.variables.size(); ++i)
      gradient[term.variables[i]] += term.J.col(static_cast<Eigen::Index>(i)).dot(own);
  }
  return gradient;
}

VectorX SparseRows::Moved(const VectorX& by) const {
  VectorX moved = VectorX::Zero(value_.size());
  for (const Term& term : terms_) {
    auto own = moved.segment(term.row, term.value.size());
    for (std::size_t i = 0; i < term.variables.size(); ++i)
      own += by[term.variables[i]] * term.J.col(static_cast<Eigen::Index>(i));
  }
  return moved;
}

bool SparseRows::Factor(const VectorX& weights, double damping) {
  VectorX values = fixed_;
  for (Term& term : terms_) {
    if (term.residual && term.affine) continue;
    term.weighted = term.J;
    if (!term.residual) term.weighted.array().colwise() *= weights.segment(term.row, term.value.size()).array().sqrt();
    AddSquare(term, values);
  }
  for (const Eigen::Index i : diagonal_) values[i] += damping;
  Eigen::Map<VectorX>(matrix_.valuePtr(), values.size()) = values;
  cholesky_.factorize(matrix_);
  return cholesky_.info() == Eigen::Success;
}

}  // namespace gaitwright
