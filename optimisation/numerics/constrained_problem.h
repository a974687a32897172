// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "kinematics/base/options.h"
#include "kinematics/base/result.h"
#include "kinematics/spatial/pose.h"
#include "optimisation/numerics/vector_function.h"

namespace gaitwright {

/// Rows of the cost. A residual that depends on a few variables should name them, which keeps a large problem sparse:
/// `function` gets only these variables, in this order, and its Jacobian has one column for each.
struct Residual {
  Residual(VectorFunction of, std::vector<int> variables_seen = {})
      : function(std::move(of)), variables(std::move(variables_seen)) {}

  VectorFunction function;
  std::vector<int> variables;  ///< on which `function` depends; empty for all
  bool affine = false;         ///< its Jacobian is constant
};

/// lower <= c(x) <= upper, row by row. Equal bounds make an equality; an infinite bound makes a one-sided constraint.
struct Constraint {
  std::string name;
  VectorFunction function;
  VectorX lower, upper;
  std::vector<int> variables = {};  ///< on which `function` depends, as in Residual; empty for all
  bool affine = false;              ///< its Jacobian is constant
  int family = 0;                   ///< a number that tells the caller what it is of
};

/// min |r(x)|^2 subject to constraints and bounds. Solved by dense factorisation up to 60 variables, by sparse
/// factorisation beyond.
struct ConstrainedProblem {
  VectorX start;  ///< initial guess
  std::vector<Residual> residuals;
  std::vector<Constraint> constraints;
  VectorX lower, upper;  ///< bounds; empty for none
  /// Of a similar problem that was solved before, as in ConstrainedSolution, from which SolveElastic starts; empty:
  /// none.
  VectorX start_multipliers = {};
};

/// Tuning
///   hundreds of iterations, steps rejected at every change of the active set   lower stiffness
///   the violation decreases slowly                                             raise stiffness
///   many steps although residuals are nearly linear                            raise trust_radius
///   many steps rejected while many bounds are active                           raise patience, set inner_tolerance to
///   1e-4
struct ConstrainedOptions {
  double tolerance = 1e-8;
  double stiffness = 10.0;
  double cost_tolerance = 1e-10;
  double trust_radius = 1e4;
  double inner_tolerance = 1e-6;
  int patience = 0;
  int max_outer = 80;
  int max_inner = 200;
  int max_steps = 16000;

  OptionFields Fields() {
    return {
        {"tolerance", &tolerance, "1", 1e-14, 1.0, "Largest constraint violation that is accepted."},
        {"stiffness", &stiffness, "1", 1e-6, 1e6,
         "Initial penalty, in units of the curvature of the cost divided by the curvature of the constraints."},
        {"cost_tolerance", &cost_tolerance, "1", 1e-14, 1.0,
         "Change of the cost between two updates, relative to 1 + cost, below which the solve has converged."},
        {"trust_radius", &trust_radius, "1", 1e-3, 1e12,
         "Initial radius of the trust region, in units of the scaled variables."},
        {"inner_tolerance", &inner_tolerance, "1", 1e-12, 0.1,
         "Relative change of the penalised cost below which the first update is made; later updates use smaller "
         "values."},
        {"patience", &patience, "1", 0, 100,
         "Consecutive steps that may raise the penalised cost; above 0, penalties grow only after steps have "
         "converged."},
        {"max_outer", &max_outer, "1", 1, 1000, "Maximum number of updates of the multipliers."},
        {"max_inner", &max_inner, "1", 1, 10000, "Maximum number of steps between two updates."},
        {"max_steps", &max_steps, "1", 1, 10000000, "Maximum number of steps in all; no update follows after them."}};
  }
};

/// A solution with solver data.
struct ConstrainedSolution {
  VectorX x;
  double cost = 0.0;        ///< |r|^2
  double violation = 0.0;   ///< largest violation
  double violations = 0.0;  ///< sum of all violations; set by SolveElastic only, as the next two
  bool least = false;       ///< small changes do not reduce it
  std::vector<std::pair<std::string, double>> unmet = {};  ///< constraints by their violation, worst first
  /// By row of the constraints: minus the derivative of the cost with respect to the active bound. Positive at an upper
  /// bound, negative at a lower bound, zero if no bound is active.
  VectorX multipliers = {};
  std::string worst_constraint;  ///< name of the constraint with the largest violation
  int worst_family = 0;          ///< its family
  int outer = 0, iterations = 0;
  std::string brief;  ///< one line
};

/// Augmented Lagrangian over Ceres. With y = c + lambda / rho, each constraint adds the residual
///   sqrt(rho) (y - clamp(y, lower, upper)),   then lambda = rho (y - clamp(y)).
/// The first rho matches the curvature of the constraints to that of the cost, which makes the iterates independent of
/// the cost's scale; rho grows if the violation does not fall. A solve that stops without a step is repeated with a
/// smaller tolerance before any update. Failure kInfeasible names the violated constraint and the amount, or that the
/// cost does not converge. @throws InvalidArgument as CheckConstrainedProblem does, and if a function is not finite at
/// the start. Nocedal and Wright, Numerical Optimization, 2006, section 17.4.
/// @param last  if given: the last iterate, also if it is not a solution.
Result<ConstrainedSolution> Solve(const ConstrainedProblem& problem, const ConstrainedOptions& options = {},
                                  ConstrainedSolution* last = nullptr);

}  // namespace gaitwright
