// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "kinematics/base/result.h"
#include "optimisation/centroidal/zmp_problem.h"

namespace gaitwright {

/// A time at which the ZMP is chosen: p = origin + basis x, with x the knot's own `size` variables from `first` on.
/// Where the region has area, x is the place in it; on a line, the fraction of its length; a knot that is given has
/// none.
struct ZmpKnot {
  double time_s = 0.0;
  std::size_t phase = 0;  ///< whose region it is held in
  int first = 0, size = 0;
  Vector2 origin_W = Vector2::Zero();
  Eigen::Matrix2d basis = Eigen::Matrix2d::Zero();  ///< its first `size` columns count
  Polygon region_W;                                 ///< where it may be
  double margin_m = 0.0;                            ///< by which that is inside of a support with area

  /// The ZMP at this knot for the unknowns x, in W [m].
  Vector2 At(const VectorX& x) const {
    return size == 0 ? origin_W : Vector2(origin_W + basis.leftCols(size) * x.segment(first, size));
  }
};

/// A sample of the grid between two knots: p = constant + left p_left + right p_right.
struct ZmpBlend {
  std::size_t left = 0, right = 0;  ///< knots
  double share = 0.0;               ///< of the way from left to right
  Eigen::Matrix2d by_left, by_right;
  Vector2 constant_W;
};

/// The ZMP as a function of few numbers: piecewise linear between knots in coordinates that move with the region, so
/// that between two knots in a region whose corners move alike, or on a line, it stays there by construction. Where
/// one region goes over into another they share the knot, which is held in the smaller of the two; where neither holds
/// the other, the ZMP jumps. The first and the last knot are given: the preferred points of standing at rest.
struct ZmpKnots {
  std::vector<ZmpKnot> knots;                              ///< by phase, then time
  std::vector<std::pair<std::size_t, std::size_t>> spans;  ///< pairs of knots with nothing but a straight piece between
  std::vector<ZmpBlend> samples;
  int num_variables = 0;

  /// The ZMP on the grid.
  std::vector<Vector2> Sample(const VectorX& x) const;
  /// By sample: what the margin between two knots comes to, 0 next to one that another support's line holds [m].
  std::vector<double> Margins() const;
};

/// Places the knots: every `spacing_s` or nearer, at least one between the ends of a phase that lasts long enough.
/// Failure kInfeasible names the phase whose support is not wide enough for the margin at both sides.
Result<ZmpKnots> PlaceZmpKnots(const ZmpProblem& problem, double margin_m, double spacing_s);

}  // namespace gaitwright
