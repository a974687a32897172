// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "optimisation/centroidal/zmp_problem.h"

namespace gaitwright {

/// Cost weights of a ZMP.
struct ZmpWeights {
  double centre = 1.0;    ///< of the squared distance to the preferred point, over time [1/(m^2 s)]
  double smooth = 1e-4;   ///< of the squared rate, over time [s/m^2]
  double margin_m = 0.0;  ///< smallest distance to the edge of the region
  double knot_spacing_s = 0.25;
};

/// A ZMP on the grid, with solver data.
struct OptimisedZmp {
  std::vector<Vector2> p_WZ;
  std::vector<double> margin_m;  ///< by sample: required distance to the edge
  int variables = 0;
  std::string brief;
};

/// The ZMP that minimises
///   integral of centre |p - preferred|^2 + smooth |p'|^2
/// over piecewise linear ZMPs in their regions (zmp_knots.h) with which the pendulum starts and ends at rest: four
/// equality rows, whose coefficients fall off exponentially and are left out below 1e-9. `guess` is the initial ZMP on
/// the grid. Failure kInfeasible names the phase and the distance of the ZMP outside its region.
Result<OptimisedZmp> OptimiseZmp(const ZmpProblem& problem, const ZmpWeights& weights,
                                 const std::vector<Vector2>& guess);

}  // namespace gaitwright
