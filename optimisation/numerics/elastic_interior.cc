// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/numerics/elastic_interior.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "optimisation/numerics/elastic_rows_internal.h"

namespace gaitwright {
namespace {

using Eigen::Index;

/// A one-sided row: sign * (value - bound) <= 0.
struct Side {
  Index row;
  double sign, bound;
};

struct Fixed {
  Index row;
  double bound;
};

/// The largest share of a step, up to 1, that leaves every v above (1 - keep) times its present value.
double Longest(const VectorX& v, const VectorX& step, double keep) {
  double longest = 1.0;
  for (Index i = 0; i < v.size(); ++i) {
    if (step[i] < 0.0) longest = std::min(longest, -keep * v[i] / step[i]);
  }
  return longest;
}

/// A point, or a step between two points.
struct Move {
  VectorX x, s, t, y, z;
};

/// = Notation =
///   s, t   slack of a side, and its violation: value + s - t = bound
///   z, w   their multipliers; z + w = penalty weight
///   y      multipliers of equality rows
class ElasticSolver {
 public:
  ElasticSolver(ElasticRows& rows, const ElasticStart& start, const ElasticOptions& options)
      : options_(options), rows_(rows), penalty_(options.penalty) {
    for (Index row = rows_.residuals(); row < rows_.count(); ++row) {
      const RowBounds bounds = rows_.BoundsOf(row);
      if (bounds.lower == bounds.upper) {
        fixed_.push_back({row, bounds.lower});
        continue;
      }
      if (std::isfinite(bounds.upper)) sides_.push_back({row, 1.0, bounds.upper});
      if (std::isfinite(bounds.lower)) sides_.push_back({row, -1.0, bounds.lower});
    }
    c_ = VectorX::Zero(static_cast<Index>(fixed_.size()));
    h_ = wanted_s_ = wanted_t_ = VectorX::Zero(static_cast<Index>(sides_.size()));
    at_ = step_ = {start.x, h_, h_, c_, h_};
    if (start.multipliers.size() == rows_.count() - rows_.residuals()) known_ = start.multipliers;
  }

  Result<ConstrainedSolution> Run();
  const ConstrainedSolution& solution() const { return solution_; }

 private:
  void Evaluate(const VectorX& x);
  void Start();
  void StartAtMultipliers();
  void StartSides(double room, double gap);
  bool IsInfeasible() const;
  void Measure();
  void Finish();
  bool Settled();
  void Factor();
  void Solve();
  void FindStep();
  bool Falls(const Move& from, double share, double most);
  double Bend(const Move& from, double share);
  void TakeStep();

  /// Change of a side's row per change of its multiplier.
  double Give(Index i) const { return at_.s[i] / at_.z[i] + at_.t[i] / (penalty_ - at_.z[i]); }
  double PrimalShare(double keep) const {
    return std::min(Longest(at_.s, step_.s, keep), Longest(at_.t, step_.t, keep));
  }
  double DualShare(double keep) const {
    return std::min(Longest(at_.z, step_.z, keep),
                    Longest(VectorX::Constant(at_.z.size(), penalty_) - at_.z, -step_.z, keep));
  }
  /// Sum of all products of s, t and their multipliers after given shares of a step.
  double Gap(double primal, double dual) const {
    const VectorX z = at_.z + dual * step_.z;
    return (at_.s + primal * step_.s).dot(z) + (at_.t + primal * step_.t).dot((penalty_ - z.array()).matrix());
  }
  /// Mean of these products.
  double Mean(double gap) const { return gap / std::max(1.0, 2.0 * static_cast<double>(sides_.size())); }
  double UnbalancedSides() const { return (h_ + at_.s - at_.t).lpNorm<1>(); }
  /// Sum of the equalities' errors that the linearised rows predict after a whole step: `give` lets errors remain until
  /// the multipliers have grown.
  double RemainingErrors() const {
    double remaining = 0.0;
    for (std::size_t i = 0; i < fixed_.size(); ++i)
      remaining += std::abs(c_[static_cast<Index>(i)] + moved_[fixed_[i].row]);
    return remaining;
  }
  /// Share of the equalities in the merit function: their weighted absolute errors; or, if the step removes less than
  /// half of them, their terms of the augmented Lagrangian, for which the step is always a descent direction.
  double EqualityMerit() const {
    return yields_ ? merit_y_.dot(c_) + 0.5 / options_.give * c_.squaredNorm() : weight_ * c_.lpNorm<1>();
  }
  double Merit() const {
    return half_cost_ + penalty_ * at_.t.sum() - mean_ * (at_.s.array().log().sum() + at_.t.array().log().sum()) +
           weight_ * UnbalancedSides() + EqualityMerit();
  }

  const ElasticOptions options_;
  ElasticRows& rows_;
  std::vector<Side> sides_;
  std::vector<Fixed> fixed_;
  VectorX known_;  // multipliers of a problem that was solved before, or empty
  Move at_, step_;
  VectorX gradient_, c_, h_, merit_y_, wanted_s_, wanted_t_, moved_;  // wanted: products of s and z, t and w
  double half_cost_ = 0.0, last_total_ = std::numeric_limits<double>::infinity();
  double penalty_, mean_ = 0.0;              // mean_: target of the products
  bool yields_ = false;                      // see EqualityMerit; merit_y_: their multipliers at the start of the step
  double weight_ = 1.0, damping_ = kLittle;  // weight_: of the equality violations in the merit function
  static constexpr double kLittle = 1e-8, kKeep = 0.99;
  ConstrainedSolution solution_;
};

void ElasticSolver::Evaluate(const VectorX& x) {
  rows_.Evaluate(x);
  const VectorX& value = rows_.value();
  half_cost_ = 0.5 * value.head(rows_.residuals()).squaredNorm();
  for (std::size_t i = 0; i < fixed_.size(); ++i) c_[static_cast<Index>(i)] = value[fixed_[i].row] - fixed_[i].bound;
  for (std::size_t i = 0; i < sides_.size(); ++i)
    h_[static_cast<Index>(i)] = sides_[i].sign * (value[sides_[i].row] - sides_[i].bound);
}

/// @throws InvalidArgument if a function is not finite.
void ElasticSolver::Start() {
  constexpr double kRoom = 1e-2, kWarmRoom = 1e-5, kWarmGap = 1e-4;
  Evaluate(at_.x);
  for (Index row = 0; row < rows_.count(); ++row) {
    if (std::isfinite(rows_.value()[row])) continue;
    throw InvalidArgument(
        row < rows_.residuals()
            ? "SolveElastic: a residual is not finite at the start"
            : fmt::format("SolveElastic: constraint '{}' is not finite at the start", rows_.NameOf(row)));
  }
  if (known_.size() > 0) StartAtMultipliers();
  known_.size() > 0 ? StartSides(kWarmRoom, kWarmGap) : StartSides(kRoom, options_.first_gap);
}

void ElasticSolver::StartAtMultipliers() {
  constexpr double kMost = 0.95;  // of the penalty weight
  const Index first = rows_.residuals();
  double largest = 0.0;  // which the penalty weight must exceed
  for (const Side& side : sides_) largest = std::max(largest, 0.5 * std::abs(known_[side.row - first]));
  while (penalty_ <= largest && penalty_ < options_.max_penalty)
    penalty_ = std::min(10.0 * penalty_, options_.max_penalty);
  for (std::size_t i = 0; i < fixed_.size(); ++i) at_.y[static_cast<Index>(i)] = 0.5 * known_[fixed_[i].row - first];
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    at_.z[static_cast<Index>(i)] =
        std::clamp(0.5 * sides_[i].sign * known_[sides_[i].row - first], 0.0, kMost * penalty_);
  }
}

/// Slacks with some room, and multipliers of at least a product with these.
void ElasticSolver::StartSides(double room, double gap) {
  for (Index i = 0; i < h_.size(); ++i) {
    at_.t[i] = std::max(h_[i], 0.0) + room;
    at_.s[i] = at_.t[i] - h_[i];
    at_.z[i] = std::max(at_.z[i], std::min(gap / at_.s[i], 0.5 * penalty_));
  }
}

/// The early check for infeasibility. A solve that is far from it is ended halfway to the check.
bool ElasticSolver::IsInfeasible() const {
  constexpr double kFar = 100.0;
  const double most = options_.infeasible * (solution_.iterations < options_.early_check ? kFar : 1.0);
  return 2 * solution_.iterations >= options_.early_check && solution_.violations > most &&
         solution_.violation > options_.infeasible_largest;
}

void ElasticSolver::Measure() {
  solution_.violations = c_.lpNorm<1>() + h_.cwiseMax(0.0).sum();
  solution_.violation =
      std::max(c_.size() > 0 ? c_.lpNorm<Eigen::Infinity>() : 0.0, h_.size() > 0 ? std::max(0.0, h_.maxCoeff()) : 0.0);
  solution_.cost = 2.0 * half_cost_;
  solution_.x = at_.x;
}

/// Stores the unmet constraints and the multipliers: those of |r|^2, which are twice those of its half.
void ElasticSolver::Finish() {
  const Index first = rows_.residuals();
  solution_.multipliers = VectorX::Zero(rows_.count() - first);
  for (std::size_t i = 0; i < fixed_.size(); ++i)
    solution_.multipliers[fixed_[i].row - first] = 2.0 * at_.y[static_cast<Index>(i)];
  for (std::size_t i = 0; i < sides_.size(); ++i)
    solution_.multipliers[sides_[i].row - first] += 2.0 * sides_[i].sign * at_.z[static_cast<Index>(i)];
  std::vector<std::pair<Index, double>> violations;
  for (std::size_t i = 0; i < fixed_.size(); ++i)
    violations.emplace_back(fixed_[i].row, std::abs(c_[static_cast<Index>(i)]));
  for (std::size_t i = 0; i < sides_.size(); ++i) violations.emplace_back(sides_[i].row, h_[static_cast<Index>(i)]);
  SetUnmet(rows_, violations, options_.tolerance, solution_);
}

/// Whether cost and violations no longer change and the multipliers satisfy the optimality conditions.
bool ElasticSolver::Settled() {
  const double total = half_cost_ + penalty_ * at_.t.sum(), change = std::abs(total - last_total_);
  const double little = options_.cost_tolerance * (1e-3 + total);
  last_total_ = total;
  return change <= little && Gap(0.0, 0.0) <= little &&
         (c_.size() == 0 || c_.lpNorm<Eigen::Infinity>() <= options_.tolerance);
}

void ElasticSolver::Factor() {
  VectorX weights = VectorX::Zero(rows_.count()), cost = weights;
  for (const Fixed& f : fixed_) weights[f.row] += 1.0 / options_.give;
  for (std::size_t i = 0; i < sides_.size(); ++i) weights[sides_[i].row] += 1.0 / Give(static_cast<Index>(i));
  while (!rows_.Factor(weights, damping_)) damping_ *= 10.0;
  cost.head(rows_.residuals()) = rows_.value().head(rows_.residuals());
  gradient_ = rows_.Gradient(cost);
}

/// Newton's step to the target products, with the present factors.
void ElasticSolver::Solve() {
  VectorX pull = VectorX::Zero(rows_.count()), off(h_.size());
  for (std::size_t k = 0; k < fixed_.size(); ++k) {
    const auto i = static_cast<Index>(k);
    pull[fixed_[k].row] += at_.y[i] + c_[i] / options_.give;
  }
  for (std::size_t k = 0; k < sides_.size(); ++k) {
    const auto i = static_cast<Index>(k);
    off[i] = h_[i] + wanted_s_[i] / at_.z[i] - wanted_t_[i] / (penalty_ - at_.z[i]);
    pull[sides_[k].row] += sides_[k].sign * (at_.z[i] + off[i] / Give(i));
  }
  step_.x = rows_.Solved(-gradient_ - rows_.Gradient(pull));
  moved_ = rows_.Moved(step_.x);
  for (std::size_t k = 0; k < fixed_.size(); ++k) {
    const auto i = static_cast<Index>(k);
    step_.y[i] = (c_[i] + moved_[fixed_[k].row]) / options_.give;
  }
  for (std::size_t k = 0; k < sides_.size(); ++k) {
    const auto i = static_cast<Index>(k);
    step_.z[i] = (sides_[k].sign * moved_[sides_[k].row] + off[i]) / Give(i);
    step_.s[i] = (wanted_s_[i] - at_.s[i] * step_.z[i]) / at_.z[i] - at_.s[i];
    step_.t[i] = (wanted_t_[i] + at_.t[i] * step_.z[i]) / (penalty_ - at_.z[i]) - at_.t[i];
  }
}

/// Mehrotra's predictor and corrector. Products fall no faster than errors of equalities: steps would become short.
void ElasticSolver::FindStep() {
  Factor();
  wanted_s_.setZero();
  wanted_t_.setZero();
  Solve();
  if (sides_.empty()) return;
  const double primal = PrimalShare(1.0), dual = DualShare(1.0);
  const double mean = Mean(Gap(0.0, 0.0)), after = Mean(Gap(primal, dual));
  constexpr double kLeast = 0.02, kSecond = 10.0;
  mean_ = mean * std::clamp(std::pow(after / mean, 3.0), kLeast, 1.0);
  mean_ = std::max({mean_, Mean(1e-3 * options_.cost_tolerance * (1e-3 + half_cost_)), Mean(c_.lpNorm<1>())});
  const double most = kSecond * mean_;
  const VectorX of_s = (primal * dual * step_.s.cwiseProduct(step_.z)).cwiseMax(-most).cwiseMin(most);
  const VectorX of_t = (primal * dual * step_.t.cwiseProduct(step_.z)).cwiseMax(-most).cwiseMin(most);
  wanted_s_ = VectorX::Constant(h_.size(), mean_) - of_s;
  wanted_t_ = VectorX::Constant(h_.size(), mean_) + of_t;
  Solve();
}

/// Takes a share of the step. @return whether the merit function is then at most `most`.
bool ElasticSolver::Falls(const Move& from, double share, double most) {
  at_.x = from.x + share * step_.x;
  at_.t = from.t + share * step_.t;
  Evaluate(at_.x);
  at_.s = (from.s + share * step_.s).cwiseMax(at_.t - h_);
  return Merit() <= most;
}

/// Second-order correction of a step that was tried, from the error of the linearised rows. @return its largest share.
double ElasticSolver::Bend(const Move& from, double share) {
  for (std::size_t i = 0; i < fixed_.size(); ++i) c_[static_cast<Index>(i)] -= share * moved_[fixed_[i].row];
  for (std::size_t i = 0; i < sides_.size(); ++i)
    h_[static_cast<Index>(i)] -= share * sides_[i].sign * moved_[sides_[i].row];
  at_ = from;
  Solve();
  return PrimalShare(kKeep);
}

/// Takes the largest step for which s, t and multipliers stay positive and the merit function falls.
void ElasticSolver::TakeStep() {
  constexpr double kEnough = 1e-4, kRound = 1e-10, kMost = 0.5;  // kMost: of errors of equalities that may stay
  constexpr int kMostHalvings = 8;
  const double remaining = RemainingErrors(), equalities = c_.lpNorm<1>(), unbalanced = UnbalancedSides();
  yields_ = remaining > kMost * equalities;
  merit_y_ = at_.y;
  double slope = gradient_.dot(step_.x) + penalty_ * step_.t.sum() -
                 mean_ * (step_.s.cwiseQuotient(at_.s).sum() + step_.t.cwiseQuotient(at_.t).sum());
  for (std::size_t i = 0; yields_ && i < fixed_.size(); ++i) {
    const auto k = static_cast<Index>(i);
    slope += (at_.y[k] + c_[k] / options_.give) * moved_[fixed_[i].row];
  }
  const double balanced = unbalanced + (yields_ ? 0.0 : equalities - remaining);  // by the whole step
  if (balanced > rows_.unnoticed()) {
    const double needed = slope / (0.9 * balanced);
    if (weight_ < needed) weight_ = 1.5 * needed;
  }
  const double descent = slope - weight_ * balanced, before = Merit();
  const auto most = [&](double share) { return before + kEnough * share * descent + kRound * std::abs(before); };
  const Move from = at_, straight = step_;
  double share = PrimalShare(kKeep);
  int halvings = 0;
  if (!Falls(from, share, most(share))) {
    const double bent = Bend(from, share);
    if (Falls(from, bent, most(bent))) {
      share = bent;
    } else {
      step_ = straight;
      do {
        share *= 0.5;
        ++halvings;
      } while (!Falls(from, share, most(share)) && halvings < kMostHalvings);
    }
  }
  at_.z = from.z;
  const double dual = DualShare(kKeep);
  rows_.Differentiate();
  at_.y = from.y + share * step_.y;
  at_.z += dual * step_.z;
  if (halvings >= 3) damping_ = std::clamp(4.0 * damping_, 100.0 * kLittle, 100.0);
  if (halvings == 0) damping_ = std::max(0.25 * damping_, kLittle);
}

Result<ConstrainedSolution> ElasticSolver::Run() {
  Start();
  solution_.outer = 1;
  for (;; ++solution_.iterations) {
    Measure();
    if (Settled()) {
      if (solution_.violation <= options_.tolerance) {
        solution_.brief = fmt::format("cost {:.9g}, violation {:.1e}, {} iterations", solution_.cost,
                                      solution_.violation, solution_.iterations);
        Finish();
        return solution_;
      }
      solution_.least = penalty_ >= options_.max_penalty;
      if (solution_.least) break;
      penalty_ = std::min(10.0 * penalty_, options_.max_penalty);
      ++solution_.outer;
      last_total_ = std::numeric_limits<double>::infinity();
    }
    if (solution_.iterations == options_.max_iterations) break;
    if (IsInfeasible()) break;
    FindStep();
    TakeStep();
  }
  Finish();
  if (solution_.violation > options_.tolerance) {
    return Failure{FailureKind::kInfeasible,
                   FailureCode::kUnmetConstraint,
                   "SolveElastic",
                   fmt::format("constraint '{}' stays violated by {:.3g} after {} iterations",
                               solution_.worst_constraint, solution_.violation, solution_.iterations),
                   {"relax this constraint, or use another initial guess"}};
  }
  return Failure{
      FailureKind::kInfeasible,
      FailureCode::kUnsettledCost,
      "SolveElastic",
      fmt::format("all constraints are satisfied, but the cost, {:.6g}, has not converged after {} iterations",
                  solution_.cost, solution_.iterations),
      {"raise max_iterations, or use another initial guess"}};
}

}  // namespace

Result<ConstrainedSolution> SolveElasticRows(ElasticRows& rows, const ElasticStart& start,
                                             const ElasticOptions& options, ConstrainedSolution* last) {
  ElasticOptions checked = options;
  CheckOptions(checked.Fields());
  ElasticSolver solver(rows, start, checked);
  Result<ConstrainedSolution> solution = solver.Run();
  if (last != nullptr) *last = solver.solution();
  return solution;
}

}  // namespace gaitwright
