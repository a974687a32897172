// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "optimisation/numerics/constrained_problem.h"

namespace gaitwright {

/// Tuning
///   problems that have a solution end with a small violation   raise max_penalty
///   problems without one take many iterations                  lower screening, infeasible
///   short steps from the start                                 raise first_gap
struct ElasticOptions {
  double tolerance = 1e-8;
  double cost_tolerance = 1e-6;
  double penalty = 10.0;
  double max_penalty = 1e3;
  double first_gap = 1e-2;
  double give = 1e-8;
  int early_check = 60;  ///< option `screening`
  double infeasible = 1e12;
  double infeasible_largest = 0.0;
  int max_iterations = 100;

  OptionFields Fields();
};

/// Solves a constrained problem by a primal-dual interior-point method for large problems with many inequalities: steps
/// do not stop at each change of the active set, unlike those of Solve. Inequalities are elastic: with a penalty weight
/// k,
///   min |r(x)|^2 / 2 + k sum t   subject to   c(x) = 0,   g(x) + s = t,   s, t >= 0,
/// which has a solution also for infeasible constraints: it ends at a local minimum of the sum of violations (global
/// for affine constraints), and at the solution of the original problem if the penalty weight exceeds all multipliers.
/// Each step solves Newton's equations with the squares of the Jacobians for curvature, twice with one factorisation
/// (Mehrotra's predictor and corrector), and is shortened until a merit function falls. If it converges with violated
/// constraints, the penalty weight is raised tenfold up to max_penalty. Failure kInfeasible names the most violated
/// constraint and the amount, or that the cost does not converge. With multipliers at the start, products begin small,
/// and the penalty weight above all multipliers. @throws InvalidArgument as Solve does, and for bounds, which must be
/// given as constraints. Nocedal and Wright, Numerical Optimization, 2006, chapters 17.2 and 19.
/// @param last  if given: the last iterate, also if it is not a solution; `outer` counts the penalty weights.
Result<ConstrainedSolution> SolveElastic(const ConstrainedProblem& problem, const ElasticOptions& options = {},
                                         ConstrainedSolution* last = nullptr);

}  // namespace gaitwright
