// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "optimisation/numerics/constrained_problem.h"

namespace gaitwright {

/// Tuning
///   problems that have a solution end with a small violation   raise most_price
///   problems without one take many iterations                  lower screening, hopeless
///   short steps from the start                                 raise first_gap
struct ElasticOptions {
  double tolerance = 1e-8;
  double cost_tolerance = 1e-6;
  double price = 10.0;
  double most_price = 1e3;
  double first_gap = 1e-2;
  double give = 1e-8;
  int screening = 60;
  double hopeless = 1e12;
  int max_iterations = 100;

  OptionFields Fields();
};

/// Solves a constrained problem by a primal-dual interior-point method for large problems with many inequalities:
/// steps do not stop at each change of the active set as those of Solve do. Inequalities are elastic: with a price k,
///   min |r(x)|^2 / 2 + k sum t   subject to   c(x) = 0,   g(x) + s = t,   s, t >= 0,
/// which has a solution whether the constraints have one or not, so that it ends where the violations' sum is least (a
/// local least; the least of all where constraints are affine), and the same solution where a price above all
/// multipliers is paid. Each step solves Newton's equations with the squares of the Jacobians for curvature, twice with
/// one factorisation (Mehrotra's predictor and corrector), and is shortened until a merit function falls. Where it
/// settles with constraints unmet the price is raised tenfold up to most_price. Failure kInfeasible names the
/// constraint that stays unmet most and by how much, or says that the cost does not settle. @throws InvalidArgument as
/// Solve, and for bounds, which are to be given as constraints. Nocedal and Wright, Numerical Optimization, 2006,
/// chapters 17.2 and 19.
/// @param last  if given: where it stood at the end, whether that is a solution or not; `outer` counts the prices.
Result<ConstrainedSolution> SolveElastic(const ConstrainedProblem& problem, const ElasticOptions& options = {},
                                         ConstrainedSolution* last = nullptr);

}  // namespace gaitwright
