// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "kinematics/base/result.h"
#include "optimisation/centroidal/zmp_problem.h"

namespace gaitwright {

/// A time at which the ZMP is a variable: p = origin + basis x, with x the knot's own `size` variables from `first` on.
/// In a region with area, x is the position in it; on a line, the fraction of its length; a given knot has no
/// variables.
struct ZmpKnot {
  double time_s = 0.0;
  std::size_t phase = 0;  ///< phase whose region constrains it
  int first = 0, size = 0;
  Vector2 origin_W = Vector2::Zero();
  Eigen::Matrix2d basis = Eigen::Matrix2d::Zero();  ///< only the first `size` columns are used
  Polygon region_W;                                 ///< its region
  double margin_m = 0.0;                            ///< margin of the region inside a support with area

  /// The ZMP at this knot for the unknowns x, in W [m].
  Vector2 At(const VectorX& x) const {
    return size == 0 ? origin_W : Vector2(origin_W + basis.leftCols(size) * x.segment(first, size));
  }
};

/// A sample of the grid between two knots: p = constant + left p_left + right p_right.
struct ZmpBlend {
  std::size_t left = 0, right = 0;  ///< knots
  double share = 0.0;               ///< fraction between left and right
  Eigen::Matrix2d by_left, by_right;
  Vector2 constant_W;
};

/// The ZMP as a function of few variables: piecewise linear between knots in coordinates that move with the region, so
/// it stays in a region whose corners move alike, or on a line, by construction. If one region follows another, they
/// share the knot, which is constrained to the smaller of the two; if neither contains the other, the ZMP jumps. The
/// first and the last knot are given: the preferred points of standing at rest.
struct ZmpKnots {
  std::vector<ZmpKnot> knots;                              ///< by phase, then time
  std::vector<std::pair<std::size_t, std::size_t>> spans;  ///< pairs of knots with a straight piece in between
  std::vector<ZmpBlend> samples;
  int num_variables = 0;

  /// The ZMP on the grid.
  std::vector<Vector2> Sample(const VectorX& x) const;
  /// By sample: margin between two knots, 0 next to a knot on another support's line [m].
  std::vector<double> Margins() const;
};

/// Places the knots: at most `spacing_s` apart, with at least one inside each phase that is long enough. Failure
/// kInfeasible names the phase whose support is not wide enough for the margin on both sides.
Result<ZmpKnots> PlaceZmpKnots(const ZmpProblem& problem, double margin_m, double spacing_s);

}  // namespace gaitwright
