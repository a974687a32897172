// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "optimisation/trajectory/chosen_rows_internal.h"

namespace gaitwright {
namespace {

using Eigen::Index;

constexpr Index kPieces = 3;  // fewer control points than this and one make no cubic B-spline

}  // namespace

PaceSpline::PaceSpline(double start_s, double end_s, VectorX points)
    : start_s_(start_s),
      step_s_((end_s - start_s) / static_cast<double>(std::max<Index>(1, points.size() - kPieces))),
      points_(std::move(points)) {}

PaceSpline::Basis PaceSpline::BasisAt(double problem_s) const {
  Basis basis;
  const Index pieces = points_.size() - kPieces;
  if (pieces < 1) return basis;
  const double at = std::clamp((problem_s - start_s_) / step_s_, 0.0, static_cast<double>(pieces));
  basis.first = std::min(static_cast<Index>(at), pieces - 1);
  const double u = at - static_cast<double>(basis.first), w = 1.0 - u;
  basis.value = {w * w * w / 6.0, (3.0 * u * u * u - 6.0 * u * u + 4.0) / 6.0,
                 (3.0 * w * w * w - 6.0 * w * w + 4.0) / 6.0, u * u * u / 6.0};
  basis.rate = {-0.5 * w * w / step_s_, (1.5 * u * u - 2.0 * u) / step_s_, -(1.5 * w * w - 2.0 * w) / step_s_,
                0.5 * u * u / step_s_};
  return basis;
}

KnotPace PaceSpline::At(double problem_s) const {
  if (points_.size() <= kPieces) return {};
  const Basis basis = BasisAt(problem_s);
  double log = 0.0, rate = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    log += basis.value[i] * points_[basis.first + static_cast<Index>(i)];
    rate += basis.rate[i] * points_[basis.first + static_cast<Index>(i)];
  }
  return {std::exp(log), std::exp(log) * rate};
}

ChosenRows::ChosenRows(const BodyProblem& problem, const BodyChoices& choices, const VectorX& start)
    : problem_(problem),
      choices_(choices),
      inner_(problem, start),
      chosen_(choices.count()),
      state_size_(3 * problem.model->nv()),
      free_(chosen_ + inner_.cycles() * state_size_) {
  if (HasPace() && choices.pace_points <= kPieces) throw InvalidArgument("ChosenRows: pace_points must be at least 4");
  if (HasPace() && inner_.HasJerks()) throw InvalidArgument("ChosenRows: limits of jerk need a pace that is given");
  const std::vector<double>& time_s = problem.time_s;
  for (std::size_t k = 0; k < time_s.size(); ++k) {
    const double before = k > 0 ? time_s[k] - time_s[k - 1] : 0.0;
    const double after = k + 1 < time_s.size() ? time_s[k + 1] - time_s[k] : 0.0;
    share_s_.push_back(0.5 * (before + after));
  }
  weight_.resize(chosen_);
  weight_.head(choices.pace_points).setConstant(choices.pace_weight);
  weight_.tail(chosen_ - choices.pace_points).setConstant(choices.foothold_weight);
  Evaluate(StartOf(start));
  Differentiate();
}

VectorX ChosenRows::StartOf(const VectorX& inner) const {
  VectorX z = VectorX::Zero(inner_.size() + free_);
  z.head(inner_.size()) = inner;
  for (std::size_t k = problem_.knots.size(); k-- > 0;) {  // a cycle's state is that of its first knot
    if (const std::optional<CycleTie>& tie = problem_.knots[k].tie)
      z.segment(inner_.size() + chosen_ + tie->cycle * state_size_, state_size_) = inner_.StateAt(k, inner);
  }
  return z;
}

PaceSpline ChosenRows::PaceOf(const VectorX& z) const {
  return {problem_.start_s(), problem_.end_s(), z.segment(inner_.size(), choices_.pace_points)};
}

std::vector<Vector3> ChosenRows::ShiftsOf(const VectorX& z) const {
  std::vector<Vector3> shifts_W;
  Index at = inner_.size() + choices_.pace_points;
  for (const ShiftedFoothold& foothold : choices_.footholds) {
    shifts_W.push_back(z[at] * foothold.along_W[0] + z[at + 1] * foothold.along_W[1]);
    at += 2;
  }
  return shifts_W;
}

/// Of all rows, those of BodyRows.
VectorX ChosenRows::InnerRows(const VectorX& rows) const {
  VectorX inner(inner_.count());
  const Index residuals = inner_.residuals(), constraints = inner_.count() - residuals;
  inner << rows.head(residuals), rows.segment(residuals + chosen_, constraints);
  return inner;
}

VectorX ChosenRows::Joined(const VectorX& inner, const VectorX& near, const VectorX& bounded, double longer) const {
  VectorX rows(inner.size() + 2 * chosen_ + (HasPace() ? 1 : 0));
  const Index residuals = inner_.residuals();
  rows.head(residuals) = inner.head(residuals);
  rows.segment(residuals, chosen_) = near;
  rows.segment(residuals + chosen_, inner.size() - residuals) = inner.tail(inner.size() - residuals);
  rows.segment(inner.size() + chosen_, chosen_) = bounded;
  if (HasPace()) rows[rows.size() - 1] = longer;
  return rows;
}

RowBounds ChosenRows::BoundsOf(Index row) const {
  if (row < inner_.count() + chosen_) return inner_.BoundsOf(row - chosen_);
  const Index choice = row - inner_.count() - chosen_;
  if (choice == chosen_) return {0.0, choices_.longest - 1.0};
  if (choice < choices_.pace_points) return {std::log(choices_.slowest), std::log(choices_.fastest)};
  const Index shift = choice - choices_.pace_points;
  const ShiftedFoothold& foothold = choices_.footholds[static_cast<std::size_t>(shift / 2)];
  const auto i = static_cast<std::size_t>(shift % 2);
  return {foothold.lower_m[i], foothold.upper_m[i]};
}

std::string ChosenRows::NameOf(Index row) const {
  if (row < inner_.count() + chosen_) return inner_.NameOf(row - chosen_);
  const Index choice = row - inner_.count() - chosen_;
  if (choice == chosen_) return "duration";
  if (choice < choices_.pace_points) return "bounds of phase durations";
  const auto foothold = static_cast<std::size_t>((choice - choices_.pace_points) / 2);
  return fmt::format("bounds of a foothold of foot '{}'", choices_.footholds[foothold].name);
}

/// By the trapezoidal rule over knots [s].
double ChosenRows::DurationOf(const PaceSpline& pace) const {
  double duration_s = 0.0;
  for (std::size_t k = 0; k < share_s_.size(); ++k) duration_s += share_s_[k] / pace.At(problem_.time_s[k]).rate;
  return duration_s;
}

void ChosenRows::Evaluate(const VectorX& z) {
  z_ = z;
  const PaceSpline pace = PaceOf(z);
  const std::vector<Vector3> shifts_W = ShiftsOf(z);
  std::vector<KnotPace> paces;
  std::vector<std::vector<Vector3>> of_goals_W;
  for (std::size_t k = 0; k < problem_.knots.size(); ++k) {
    paces.push_back(pace.At(problem_.time_s[k]));
    of_goals_W.emplace_back(problem_.knots[k].feet.size(), Vector3::Zero());
  }
  for (std::size_t i = 0; i < shifts_W.size(); ++i) {
    for (const ShiftedFoothold::Share& share : choices_.footholds[i].shares)
      of_goals_W[static_cast<std::size_t>(share.knot)][share.goal] += share.share * shifts_W[i];
  }
  inner_.SetChosen(paces, of_goals_W);
  std::vector<VectorX> states;
  for (Index at = inner_.size() + chosen_; at < z.size(); at += state_size_)
    states.emplace_back(z.segment(at, state_size_));
  inner_.SetCycles(std::move(states));
  inner_.Evaluate(InnerOf(z));
  const double problem_s = problem_.end_s() - problem_.start_s();
  const VectorX chosen = z.segment(inner_.size(), chosen_);
  value_ = Joined(inner_.value(), weight_.cwiseProduct(chosen), chosen, DurationOf(pace) / problem_s - 1.0);
}

void ChosenRows::Differentiate() {
  inner_.Differentiate();
  std::vector<Eigen::Triplet<double>> entries;
  VectorX moved = VectorX::Zero(inner_.count());
  const auto take = [&](std::size_t k, Index column) {
    for (const auto& [first, end] : inner_.RowsOf(k)) {
      for (Index row = first; row < end; ++row) {
        if (moved[row] != 0.0) entries.emplace_back(row, column, moved[row]);
      }
    }
  };
  longer_by_ = VectorX::Zero(chosen_);
  const double problem_s = problem_.end_s() - problem_.start_s();
  const PaceSpline pace = PaceOf(z_);
  for (std::size_t k = 0; HasPace() && k < problem_.knots.size(); ++k) {
    const KnotPace now = pace.At(problem_.time_s[k]);
    const PaceSpline::Basis basis = pace.BasisAt(problem_.time_s[k]);
    for (std::size_t i = 0; i < 4; ++i) {
      const Index column = basis.first + static_cast<Index>(i);
      longer_by_[column] -= share_s_[k] * basis.value[i] / now.rate / problem_s;
      inner_.MovedByPace(k, {now.rate * basis.value[i], basis.value[i] * now.slope + now.rate * basis.rate[i]}, moved);
      take(k, column);
    }
  }
  Index column = choices_.pace_points;
  for (const ShiftedFoothold& foothold : choices_.footholds) {
    for (const Vector3& along_W : foothold.along_W) {
      for (const ShiftedFoothold::Share& share : foothold.shares) {
        inner_.MovedByShift(static_cast<std::size_t>(share.knot), share.goal, share.share * along_W, moved);
        take(static_cast<std::size_t>(share.knot), column);
      }
      ++column;
    }
  }
  for (std::size_t k = 0; k < problem_.knots.size(); ++k) {
    if (!problem_.knots[k].tie) continue;
    for (Index i = 0; i < state_size_; ++i) {
      inner_.MovedByCycle(k, VectorX::Unit(state_size_, i), moved);
      take(k, chosen_ + problem_.knots[k].tie->cycle * state_size_ + i);
    }
  }
  border_.resize(inner_.count(), free_);
  border_.setFromTriplets(entries.begin(), entries.end());
}

VectorX ChosenRows::Gradient(const VectorX& by) const {
  const VectorX inner = InnerRows(by);
  VectorX gradient(inner_.size() + free_);
  gradient.head(inner_.size()) = inner_.Gradient(inner);
  gradient.tail(free_) = border_.transpose() * inner;
  auto chosen = gradient.segment(inner_.size(), chosen_);
  chosen +=
      weight_.cwiseProduct(by.segment(inner_.residuals(), chosen_)) + by.segment(inner_.count() + chosen_, chosen_);
  if (HasPace()) chosen += by[by.size() - 1] * longer_by_;
  return gradient;
}

VectorX ChosenRows::Moved(const VectorX& by) const {
  const VectorX chosen = by.segment(inner_.size(), chosen_);
  return Joined(inner_.Moved(InnerOf(by)) + border_ * by.tail(free_), weight_.cwiseProduct(chosen), chosen,
                longer_by_.dot(chosen));
}

bool ChosenRows::Factor(const VectorX& weights, double damping) {
  VectorX inner = InnerRows(weights);
  if (!inner_.Factor(inner, damping)) return false;
  inner.head(inner_.residuals()).setOnes();
  MatrixX own = border_.transpose() * inner.asDiagonal() * border_;
  own.diagonal().head(chosen_) += weight_.cwiseAbs2() + weights.segment(inner_.count() + chosen_, chosen_);
  own.diagonal().array() += damping;
  if (HasPace())
    own.topLeftCorner(chosen_, chosen_) += weights[weights.size() - 1] * longer_by_ * longer_by_.transpose();
  MatrixX coupled = MatrixX::Zero(inner_.size(), free_);
  VectorX rows = VectorX::Zero(inner_.count()), gradient(inner_.size());
  for (Index j = 0; j < free_; ++j) {
    std::size_t first = problem_.knots.size(), end = 0;
    for (Eigen::SparseMatrix<double>::InnerIterator entry(border_, j); entry; ++entry)
      rows[entry.row()] = inner[entry.row()] * entry.value();
    for (std::size_t k = 0; k < problem_.knots.size(); ++k) {
      for (const auto& [from, to] : inner_.RowsOf(k)) {
        if (rows.segment(from, to - from).isZero(0.0)) continue;
        first = std::min(first, k);
        end = k + 1;
      }
    }
    gradient.setZero();
    for (std::size_t k = first; k < end; ++k) inner_.AddGradient(k, rows, gradient);
    coupled.col(j) = gradient;
    for (Eigen::SparseMatrix<double>::InnerIterator entry(border_, j); entry; ++entry) rows[entry.row()] = 0.0;
  }
  eliminated_ = inner_.SolvedAll(coupled);
  own -= coupled.transpose() * eliminated_;
  factors_.compute(own);
  return factors_.info() == Eigen::Success;
}

VectorX ChosenRows::Solved(const VectorX& right) const {
  VectorX solved(right.size());
  const VectorX inner = right.head(inner_.size());
  const VectorX chosen = factors_.solve(right.tail(free_) - eliminated_.transpose() * inner);
  solved << inner_.Solved(inner) - eliminated_ * chosen, chosen;
  return solved;
}

}  // namespace gaitwright
