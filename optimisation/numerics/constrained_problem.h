// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "kinematics/base/options.h"
#include "kinematics/base/result.h"
#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// A vector function of the variables. `J` is null when it is not wanted; else size value x variables, to be filled.
using VectorFunction = std::function<void(const VectorX& x, VectorX& value, MatrixX* J)>;

/// A function given by its values alone: the Jacobian by central differences.
VectorFunction Differenced(std::function<void(const VectorX& x, VectorX& value)> function);

/// lower <= c(x) <= upper by rows; an equality where both are the same, one-sided with an infinite end.
struct Constraint {
  std::string name;
  VectorFunction function;
  VectorX lower, upper;
};

/// min |r(x)|^2 subject to constraints and bounds, dense.
struct ConstrainedProblem {
  VectorX start;  ///< first guess
  std::vector<VectorFunction> residuals;
  std::vector<Constraint> constraints;
  VectorX lower, upper;  ///< bounds; empty for none
};

/// Tuning
///   hundreds of iterations, steps rejected at every change of the active set   lower stiffness
///   the violation goes down slowly                                             raise stiffness
struct ConstrainedOptions {
  double tolerance = 1e-8;
  double stiffness = 10.0;
  int max_outer = 80;
  int max_inner = 200;

  OptionFields Fields() {
    return {{"tolerance", &tolerance, "1", 1e-14, 1.0, "Largest violation of a constraint that counts as none.", {}},
            {"stiffness",
             &stiffness,
             "1",
             1e-6,
             1e6,
             "First penalty, in units of the curvature of the cost over that of the constraints.",
             {}},
            {"max_outer", &max_outer, "1", 1, 1000, "Most updates of the multipliers.", {}},
            {"max_inner", &max_inner, "1", 1, 10000, "Most steps between two updates.", {}}};
  }
};

/// What a solution is and how it came about.
struct ConstrainedSolution {
  VectorX x;
  double cost = 0.0;             ///< |r|^2
  double violation = 0.0;        ///< largest
  std::string worst_constraint;  ///< name of the constraint with that violation
  int outer = 0, iterations = 0;
  std::string brief;  ///< one line
};

/// Augmented Lagrangian over Ceres. With y = c + lambda / rho, each constraint adds the residual
///   sqrt(rho) (y - clamp(y, lower, upper)),   then lambda = rho (y - clamp(y)).
/// The first rho matches the curvature of the constraints to that of the cost, which makes the path the same whatever
/// the cost's scale; rho grows where the violation does not fall. A solve that stops without having moved is repeated
/// with a finer tolerance before anything is updated. Failure kInfeasible names the constraint that stays unmet and by
/// how much. Nocedal and Wright, Numerical Optimization, 2006, section 17.4.
Result<ConstrainedSolution> Solve(const ConstrainedProblem& problem, const ConstrainedOptions& options = {});

}  // namespace gaitwright
