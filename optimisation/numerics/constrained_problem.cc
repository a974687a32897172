// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/numerics/constrained_problem.h"

#include <ceres/ceres.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gaitwright {
namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// A constraint with its multipliers and penalty, shared with the cost that Ceres sees.
struct Penalised {
  const Constraint* constraint;
  VectorX lambda;
  double rho = 1.0;

  /// y - clamp(y): what is left outside of the interval.
  VectorX Excess(const VectorX& c) const {
    const VectorX y = c + lambda / rho;
    return y - y.cwiseMax(constraint->lower).cwiseMin(constraint->upper);
  }
};

/// A residual, or a constraint's penalty, as Ceres wants it.
class Cost final : public ceres::CostFunction {
 public:
  Cost(const VectorFunction& function, int rows, int variables, const Penalised* penalised)
      : function_(function), penalised_(penalised) {
    set_num_residuals(rows);
    mutable_parameter_block_sizes()->push_back(variables);
  }

  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override {
    const int variables = parameter_block_sizes()[0];
    const VectorX x = Eigen::Map<const VectorX>(parameters[0], variables);
    VectorX value(num_residuals());
    MatrixX J = MatrixX::Zero(num_residuals(), variables);
    const bool wants_jacobian = jacobians != nullptr && jacobians[0] != nullptr;
    function_(x, value, wants_jacobian ? &J : nullptr);
    if (!value.allFinite()) return false;
    if (penalised_ != nullptr) {
      const VectorX excess = penalised_->Excess(value);
      const double root = std::sqrt(penalised_->rho);
      for (Eigen::Index i = 0; i < excess.size(); ++i) {
        if (excess[i] == 0.0) J.row(i).setZero();
      }
      value = root * excess;
      J *= root;
    }
    Eigen::Map<VectorX>(residuals, value.size()) = value;
    if (wants_jacobian) Eigen::Map<RowMajor>(jacobians[0], J.rows(), J.cols()) = J;
    return true;
  }

 private:
  const VectorFunction& function_;
  const Penalised* penalised_;
};

void Identity(const VectorX& x, VectorX& value, MatrixX* J) {
  value = x;
  if (J != nullptr) J->setIdentity();
}

/// Runs the outer loop.
class Solver {
 public:
  Solver(const ConstrainedProblem& problem, const ConstrainedOptions& options)
      : problem_(problem), options_(options), x_(problem.start) {
    if (problem.lower.size() > 0) {
      x_ = x_.cwiseMax(problem.lower).cwiseMin(problem.upper);
      bounds_ = {"bounds", Identity, problem.lower, problem.upper};
      penalised_.push_back({&bounds_, VectorX::Zero(problem.lower.size()), 1.0});
    }
    for (const Constraint& constraint : problem.constraints) {
      penalised_.push_back({&constraint, VectorX::Zero(constraint.lower.size()), 1.0});
    }
    MatchCurvature();
    Build();
  }

  Result<ConstrainedSolution> Run() {
    double last_violation = std::numeric_limits<double>::infinity(), last_cost = last_violation;
    double tolerance = 1e-6;
    int stalled = 0, stagnant = 0;
    for (solution_.outer = 1; solution_.outer <= options_.max_outer; ++solution_.outer) {
      const bool moved = Minimise(tolerance);
      Measure();
      if (!moved && solution_.violation > options_.tolerance && stalled < 4) {
        tolerance *= 1e-3;
        ++stalled;
        continue;
      }
      stalled = 0;
      const bool settled = std::abs(solution_.cost - last_cost) <= 1e-10 * (1.0 + solution_.cost);
      if (solution_.violation <= options_.tolerance && settled) return Finished();
      last_cost = solution_.cost;
      UpdateMultipliers();
      const bool capped = GrowPenalty(last_violation);
      stagnant = capped && solution_.violation > 0.9 * last_violation ? stagnant + 1 : 0;
      if (stagnant >= 3 && solution_.violation > options_.tolerance) break;
      last_violation = solution_.violation;
      tolerance = std::max(0.3 * tolerance, 1e-16);
    }
    return Unmet();
  }

 private:
  void Build() {
    const int n = static_cast<int>(x_.size());
    ceres_problem_.AddParameterBlock(x_.data(), n);
    VectorX value;
    for (const VectorFunction& residual : problem_.residuals) {
      residual(x_, value, nullptr);
      ceres_problem_.AddResidualBlock(new Cost(residual, static_cast<int>(value.size()), n, nullptr), nullptr,
                                      x_.data());
    }
    for (Penalised& p : penalised_) {
      const int rows = static_cast<int>(p.lambda.size());
      ceres_problem_.AddResidualBlock(new Cost(p.constraint->function, rows, n, &p), nullptr, x_.data());
    }
  }

  /// rho = stiffness * median_j of the cost's curvature over the constraints', by variable.
  void MatchCurvature() {
    VectorX of_cost = VectorX::Zero(x_.size()), of_constraints = of_cost, value;
    MatrixX J;
    const auto add = [&](const VectorFunction& function, VectorX& sum) {
      function(x_, value, nullptr);
      J.setZero(value.size(), x_.size());
      function(x_, value, &J);
      sum += J.colwise().squaredNorm().transpose();
    };
    for (const VectorFunction& residual : problem_.residuals) add(residual, of_cost);
    for (const Penalised& p : penalised_) add(p.constraint->function, of_constraints);
    std::vector<double> ratios;
    for (Eigen::Index j = 0; j < x_.size(); ++j) {
      if (of_constraints[j] > 0.0 && of_cost[j] > 0.0) ratios.push_back(of_cost[j] / of_constraints[j]);
    }
    first_rho_ = options_.stiffness;
    if (!ratios.empty()) {
      std::nth_element(ratios.begin(), ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2), ratios.end());
      first_rho_ *= ratios[ratios.size() / 2];
    }
    for (Penalised& p : penalised_) p.rho = first_rho_;
  }

  /// @return whether it took more than one step.
  bool Minimise(double tolerance) {
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::DENSE_QR;
    options.max_num_iterations = options_.max_inner;
    options.function_tolerance = tolerance;
    options.gradient_tolerance = 1e-15;
    options.parameter_tolerance = 1e-15;
    options.logging_type = ceres::SILENT;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &ceres_problem_, &summary);
    solution_.iterations += summary.num_successful_steps + summary.num_unsuccessful_steps;
    return summary.num_successful_steps > 1;
  }

  void Measure() {
    VectorX value;
    solution_.cost = 0.0;
    for (const VectorFunction& residual : problem_.residuals) {
      residual(x_, value, nullptr);
      solution_.cost += value.squaredNorm();
    }
    solution_.violation = 0.0;
    for (const Penalised& p : penalised_) {
      p.constraint->function(x_, value, nullptr);
      const double worst =
          (value - value.cwiseMax(p.constraint->lower).cwiseMin(p.constraint->upper)).cwiseAbs().maxCoeff();
      if (worst >= solution_.violation) {
        solution_.violation = worst;
        solution_.worst_constraint = p.constraint->name;
      }
    }
  }

  void UpdateMultipliers() {
    VectorX value;
    for (Penalised& p : penalised_) {
      p.constraint->function(x_, value, nullptr);
      p.lambda = p.rho * p.Excess(value);
    }
  }

  /// @return true when the penalty is at its cap.
  bool GrowPenalty(double last_violation) {
    constexpr double kGrowth = 10.0, kCap = 1e5, kEnough = 0.25;
    const bool slow = solution_.violation > options_.tolerance && solution_.violation > kEnough * last_violation;
    bool capped = !penalised_.empty();
    for (Penalised& p : penalised_) {
      if (slow) p.rho = std::min(p.rho * kGrowth, kCap * first_rho_);
      capped = capped && p.rho >= kCap * first_rho_;
    }
    return capped;
  }

  Result<ConstrainedSolution> Finished() {
    solution_.x = problem_.lower.size() > 0 ? VectorX(x_.cwiseMax(problem_.lower).cwiseMin(problem_.upper)) : x_;
    solution_.brief = fmt::format("cost {:.9g}, violation {:.1e}, {} updates, {} iterations", solution_.cost,
                                  solution_.violation, solution_.outer, solution_.iterations);
    return solution_;
  }

  Failure Unmet() const {
    return {FailureKind::kInfeasible,
            "unmet_constraint",
            "Solve",
            fmt::format("constraint '{}' stays unmet by {:.3g} after {} updates and {} iterations",
                        solution_.worst_constraint, solution_.violation, solution_.outer, solution_.iterations),
            {"relax that constraint, or start elsewhere"}};
  }

  const ConstrainedProblem& problem_;
  const ConstrainedOptions options_;
  VectorX x_;
  Constraint bounds_;  // as one more constraint: smoother for Levenberg and Marquardt than projected steps
  std::vector<Penalised> penalised_;
  double first_rho_ = 1.0;
  ceres::Problem ceres_problem_;
  ConstrainedSolution solution_;
};

}  // namespace

VectorFunction Differenced(std::function<void(const VectorX& x, VectorX& value)> function) {
  return [function = std::move(function)](const VectorX& x, VectorX& value, MatrixX* J) {
    function(x, value);
    if (J == nullptr) return;
    VectorX moved = x, above = value, below = value;
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      const double step = 6e-6 * std::max(1.0, std::abs(x[i]));
      moved[i] = x[i] + step;
      function(moved, above);
      moved[i] = x[i] - step;
      function(moved, below);
      moved[i] = x[i];
      J->col(i) = (above - below) / (2.0 * step);
    }
  };
}

Result<ConstrainedSolution> Solve(const ConstrainedProblem& problem, const ConstrainedOptions& options) {
  ConstrainedOptions checked = options;
  CheckOptions(checked.Fields());
  if (problem.start.size() == 0 || !problem.start.allFinite())
    throw InvalidArgument("Solve: the start must be finite and not empty");
  return Solver(problem, options).Run();
}

}  // namespace gaitwright
