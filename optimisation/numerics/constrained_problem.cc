// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/numerics/constrained_problem.h"

#include <ceres/ceres.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <numeric>

#include "optimisation/numerics/check_problem.h"
#include "optimisation/numerics/variable_blocks_internal.h"

namespace gaitwright {
namespace {

/// A function of some of the variables with memory for its evaluation; for a constraint, also its multipliers and
/// penalty.
struct Term {
  const VectorFunction* function;
  std::vector<int> variables;
  const Constraint* constraint = nullptr;  // null: a residual
  bool is_equality = false;
  VectorX lambda = {};
  double rho = 1.0;
  bool affine = false;
  VectorX x = {}, value = {}, violation = {};
  MatrixX J = {};
  bool has_jacobian = false;  ///< J is that of an affine function

  /// The Jacobian of an affine function is computed once.
  void Evaluate(bool wants_jacobian) {
    const bool computes = wants_jacobian && !has_jacobian;
    if (computes) J.setZero();
    (*function)(x, value, computes ? &J : nullptr);
    has_jacobian = has_jacobian || (computes && affine);
  }

  void EvaluateAt(const VectorX& all, bool wants_jacobian) {
    for (std::size_t i = 0; i < variables.size(); ++i) x[static_cast<Eigen::Index>(i)] = all[variables[i]];
    Evaluate(wants_jacobian);
  }

  /// y - clamp(y): the part outside of the interval.
  void FindViolations() {
    violation = value + lambda / rho;
    violation -= violation.cwiseMax(constraint->lower).cwiseMin(constraint->upper);
  }

  double Violation() const {
    return (value - value.cwiseMax(constraint->lower).cwiseMin(constraint->upper)).cwiseAbs().maxCoeff();
  }
};

/// Position of a term's variable in the term's blocks.
struct Place {
  std::size_t block;
  int offset;
};

/// A term as a Ceres cost function. Evaluates in the term's own memory, so it is not thread-safe.
class Cost final : public ceres::CostFunction {
 public:
  Cost(Term& term, const std::vector<VariableBlock>& blocks, std::vector<Place> places)
      : term_(term), places_(std::move(places)) {
    set_num_residuals(static_cast<int>(term.value.size()));
    for (const VariableBlock& block : blocks) mutable_parameter_block_sizes()->push_back(block.size);
  }

  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override {
    for (std::size_t i = 0; i < places_.size(); ++i) {
      term_.x[static_cast<Eigen::Index>(i)] = parameters[places_[i].block][places_[i].offset];
    }
    const bool is_bounded = term_.constraint != nullptr && !term_.is_equality;
    if (is_bounded && jacobians != nullptr) {  // most inequalities are inactive, and need no Jacobian
      term_.Evaluate(false);
      if (!term_.value.allFinite()) return false;
      term_.FindViolations();
      if (term_.violation.isZero(0.0)) {
        WriteZeros(residuals, jacobians);
        return true;
      }
    }
    term_.Evaluate(jacobians != nullptr);
    if (!term_.value.allFinite() || (jacobians != nullptr && !term_.J.allFinite())) return false;
    double root = 1.0;
    const VectorX* out = &term_.value;
    if (term_.constraint != nullptr) {
      term_.FindViolations();
      root = std::sqrt(term_.rho);
      out = &term_.violation;
    }
    Eigen::Map<VectorX>(residuals, out->size()) = root * *out;
    if (jacobians != nullptr) WriteJacobians(root, jacobians);
    return true;
  }

 private:
  void WriteZeros(double* residuals, double** jacobians) const {
    std::fill_n(residuals, num_residuals(), 0.0);
    for (std::size_t b = 0; b < parameter_block_sizes().size(); ++b) {
      if (jacobians[b] != nullptr) std::fill_n(jacobians[b], num_residuals() * parameter_block_sizes()[b], 0.0);
    }
  }

  void WriteJacobians(double root, double** jacobians) const {
    for (std::size_t i = 0; i < places_.size(); ++i) {
      double* block = jacobians[places_[i].block];
      if (block == nullptr) continue;
      const int width = parameter_block_sizes()[places_[i].block];
      for (Eigen::Index row = 0; row < term_.J.rows(); ++row) {
        const bool active = term_.constraint == nullptr || term_.violation[row] != 0.0;
        block[row * width + places_[i].offset] = active ? root * term_.J(row, static_cast<Eigen::Index>(i)) : 0.0;
      }
    }
  }

  Term& term_;
  const std::vector<Place> places_;
};

void Identity(const VectorX& x, VectorX& value, MatrixX* J) {
  value = x;
  if (J != nullptr) J->setIdentity();
}

/// The outer loop of the augmented Lagrangian.
class Solver {
 public:
  Solver(const ConstrainedProblem& problem, const ConstrainedOptions& options)
      : problem_(problem), options_(options), x_(problem.start) {
    const int n = static_cast<int>(x_.size());
    for (const Residual& r : problem.residuals) {
      terms_.push_back({&r.function, CheckedVariables(r.variables, n)});
      terms_.back().affine = r.affine;
    }
    for (const Constraint& c : problem.constraints) {
      terms_.push_back({&c.function, CheckedVariables(c.variables, n), &c, c.lower == c.upper});
      terms_.back().affine = c.affine;
    }
    std::vector<const std::vector<int>*> seen;
    for (const Term& term : terms_) seen.push_back(&term.variables);
    blocks_ = BlocksOf(seen, n);
    AddBounds();
    for (Term& term : terms_) MakeRoom(term);
    MatchCurvature();
    Build();
  }

  Result<ConstrainedSolution> Run() {
    double last_violation = std::numeric_limits<double>::infinity(), last_cost = last_violation;
    double tolerance = options_.inner_tolerance;
    int stalled = 0, stagnant = 0;
    for (solution_.outer = 1; solution_.outer <= options_.max_outer; ++solution_.outer) {
      const auto [moved, converged] = Minimise(tolerance);
      Measure();
      const bool spent = solution_.iterations >= options_.max_steps;
      if (!moved && !spent && solution_.violation > options_.tolerance && stalled < 4) {
        tolerance *= 1e-3;
        ++stalled;
        continue;
      }
      stalled = 0;
      const bool settled = std::abs(solution_.cost - last_cost) <= options_.cost_tolerance * (1.0 + solution_.cost);
      if (solution_.violation <= options_.tolerance && settled && converged) return Finished();
      if (spent) break;
      last_cost = solution_.cost;
      UpdateMultipliers();
      const bool capped = (converged || options_.patience == 0) && GrowPenalty(last_violation);
      stagnant = capped && solution_.violation > 0.9 * last_violation ? stagnant + 1 : 0;
      if (stagnant >= 3 && solution_.violation > options_.tolerance) break;
      last_violation = solution_.violation;
      tolerance = std::max(0.3 * tolerance, 1e-16);
    }
    solution_.outer = std::min(solution_.outer, options_.max_outer);
    return solution_.violation > options_.tolerance ? Unmet() : Unsettled();
  }

  ConstrainedSolution last() const {
    ConstrainedSolution last = solution_;
    last.x = x_;
    last.multipliers = Multipliers();
    return last;
  }

 private:
  /// Adds bounds as constraints, by block. This is smoother for Levenberg-Marquardt than projected steps.
  void AddBounds() {
    if (problem_.lower.size() == 0) return;
    x_ = x_.cwiseMax(problem_.lower).cwiseMin(problem_.upper);
    for (const VariableBlock& block : blocks_) {
      std::vector<int> variables(static_cast<std::size_t>(block.size));
      std::iota(variables.begin(), variables.end(), block.start);
      bounds_.push_back({"bounds", Identity, problem_.lower.segment(block.start, block.size),
                         problem_.upper.segment(block.start, block.size), variables});
    }
    for (const Constraint& bound : bounds_) terms_.push_back({&bound.function, bound.variables, &bound});
  }

  void MakeRoom(Term& term) {
    term.x.setZero(static_cast<Eigen::Index>(term.variables.size()));
    if (term.constraint != nullptr) {
      term.lambda.setZero(term.constraint->lower.size());
      term.value = term.violation = term.lambda;
      has_constraints_ = true;
    }
    term.EvaluateAt(x_, false);
    if (!term.value.allFinite()) {
      throw InvalidArgument(
          term.constraint == nullptr
              ? "Solve: a residual is not finite at the start"
              : fmt::format("Solve: constraint '{}' is not finite at the start", term.constraint->name));
    }
    term.J.setZero(term.value.size(), term.x.size());
  }

  void Build() {
    for (const VariableBlock& block : blocks_) ceres_problem_.AddParameterBlock(x_.data() + block.start, block.size);
    std::vector<Place> where(static_cast<std::size_t>(x_.size()));
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
      for (int i = 0; i < blocks_[b].size; ++i) where[static_cast<std::size_t>(blocks_[b].start + i)] = {b, i};
    }
    std::vector<std::size_t> slot(blocks_.size());
    for (Term& term : terms_) {
      std::vector<VariableBlock> own;
      std::vector<double*> pointers;
      std::fill(slot.begin(), slot.end(), blocks_.size());
      std::vector<Place> places;
      for (const int v : term.variables) {
        const Place& at = where[static_cast<std::size_t>(v)];
        if (slot[at.block] == blocks_.size()) {
          slot[at.block] = own.size();
          own.push_back(blocks_[at.block]);
          pointers.push_back(x_.data() + blocks_[at.block].start);
        }
        places.push_back({slot[at.block], at.offset});
      }
      ceres_problem_.AddResidualBlock(new Cost(term, own, std::move(places)), nullptr, pointers);
    }
  }

  /// rho = stiffness * median over the variables of (curvature of the cost / curvature of the constraints).
  void MatchCurvature() {
    VectorX of_cost = VectorX::Zero(x_.size()), of_constraints = of_cost;
    for (Term& term : terms_) {
      term.EvaluateAt(x_, true);
      VectorX& sum = term.constraint == nullptr ? of_cost : of_constraints;
      for (std::size_t i = 0; i < term.variables.size(); ++i)
        sum[term.variables[i]] += term.J.col(static_cast<Eigen::Index>(i)).squaredNorm();
    }
    std::vector<double> ratios;
    for (Eigen::Index j = 0; j < x_.size(); ++j) {
      if (of_constraints[j] > 0.0 && of_cost[j] > 0.0) ratios.push_back(of_cost[j] / of_constraints[j]);
    }
    first_rho_ = options_.stiffness;
    if (!ratios.empty()) {
      std::nth_element(ratios.begin(), ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2), ratios.end());
      first_rho_ *= ratios[ratios.size() / 2];
    }
    for (Term& term : terms_) term.rho = first_rho_;
  }

  struct Minimised {
    bool moved, converged;
  };

  Minimised Minimise(double tolerance) {
    ceres::Solver::Options options;
    constexpr int kLargestDense = 60;
    options.linear_solver_type = x_.size() > kLargestDense ? ceres::SPARSE_NORMAL_CHOLESKY : ceres::DENSE_QR;
    options.sparse_linear_algebra_library_type = ceres::EIGEN_SPARSE;
    options.num_threads = 1;
    options.initial_trust_region_radius = options_.trust_radius;
    options.use_nonmonotonic_steps = options_.patience > 0;
    if (options_.patience > 0) options.max_consecutive_nonmonotonic_steps = options_.patience;
    options.max_num_iterations = options_.max_inner;
    options.function_tolerance = tolerance;
    options.gradient_tolerance = 1e-15;
    options.parameter_tolerance = 1e-15;
    options.logging_type = ceres::SILENT;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &ceres_problem_, &summary);
    solution_.iterations += summary.num_successful_steps + summary.num_unsuccessful_steps;
    // The first evaluation counts as a successful step.
    return {summary.num_successful_steps > 1, summary.termination_type == ceres::CONVERGENCE};
  }

  void Measure() {
    solution_.cost = solution_.violation = 0.0;
    for (Term& term : terms_) {
      term.EvaluateAt(x_, false);
      if (term.constraint == nullptr) {
        solution_.cost += term.value.squaredNorm();
      } else if (const double worst = term.Violation(); worst >= solution_.violation) {
        solution_.violation = worst;
        solution_.worst_constraint = term.constraint->name;
        solution_.worst_family = term.constraint->family;
      }
    }
  }

  /// Uses the values that Measure computed.
  void UpdateMultipliers() {
    for (Term& term : terms_) {
      if (term.constraint == nullptr) continue;
      term.FindViolations();
      term.lambda = term.rho * term.violation;
    }
  }

  /// Multipliers of |r|^2; Ceres minimises half of the sum of squares.
  VectorX Multipliers() const {
    VectorX multipliers(0);
    const std::size_t first = problem_.residuals.size();
    for (std::size_t t = first; t < first + problem_.constraints.size(); ++t) {
      multipliers.conservativeResize(multipliers.size() + terms_[t].lambda.size());
      multipliers.tail(terms_[t].lambda.size()) = 2.0 * terms_[t].lambda;
    }
    return multipliers;
  }

  /// @return true if the penalty has reached its maximum.
  bool GrowPenalty(double last_violation) {
    constexpr double kGrowth = 10.0, kCap = 1e5, kEnough = 0.25;
    const bool slow = solution_.violation > options_.tolerance && solution_.violation > kEnough * last_violation;
    for (Term& term : terms_) {
      if (slow) term.rho = std::min(term.rho * kGrowth, kCap * first_rho_);
    }
    return has_constraints_ && terms_.back().rho >= kCap * first_rho_;
  }

  Result<ConstrainedSolution> Finished() {
    UpdateMultipliers();
    solution_.multipliers = Multipliers();
    solution_.x = problem_.lower.size() > 0 ? VectorX(x_.cwiseMax(problem_.lower).cwiseMin(problem_.upper)) : x_;
    solution_.brief = fmt::format("cost {:.9g}, violation {:.1e}, {} updates, {} iterations", solution_.cost,
                                  solution_.violation, solution_.outer, solution_.iterations);
    return solution_;
  }

  Failure Unmet() const {
    return {FailureKind::kInfeasible,
            FailureCode::kUnmetConstraint,
            "Solve",
            fmt::format("constraint '{}' stays violated by {:.3g} after {} updates and {} iterations",
                        solution_.worst_constraint, solution_.violation, solution_.outer, solution_.iterations),
            {"relax this constraint, or use another initial guess"}};
  }

  Failure Unsettled() const {
    return {
        FailureKind::kInfeasible,
        FailureCode::kUnsettledCost,
        "Solve",
        fmt::format(
            "all constraints are satisfied, but the cost, {:.6g}, has not converged after {} updates and {} iterations",
            solution_.cost, solution_.outer, solution_.iterations),
        {"raise max_outer, max_inner or max_steps, or use another initial guess"}};
  }

  const ConstrainedProblem& problem_;
  const ConstrainedOptions options_;
  VectorX x_;
  std::deque<Constraint> bounds_;
  std::vector<Term> terms_;
  std::vector<VariableBlock> blocks_;
  bool has_constraints_ = false;
  double first_rho_ = 1.0;
  ceres::Problem ceres_problem_;
  ConstrainedSolution solution_;
};

}  // namespace

Result<ConstrainedSolution> Solve(const ConstrainedProblem& problem, const ConstrainedOptions& options,
                                  ConstrainedSolution* last) {
  ConstrainedOptions checked = options;
  CheckOptions(checked.Fields());
  CheckConstrainedProblem(problem);
  Solver solver(problem, options);
  Result<ConstrainedSolution> solution = solver.Run();
  if (last != nullptr) *last = solver.last();
  return solution;
}

}  // namespace gaitwright
