// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "kinematics/model/robot_model.h"
#include "kinematics/trajectory/swing_curve.h"
#include "optimisation/swing/former_motion.h"
#include "planning/audit/tolerances.h"

namespace gaitwright {

/// Height of the ground at a point in plan view [m]; -infinity without ground.
using GroundHeight = std::function<double(const Vector2& p_W)>;

/// Points of a foot's underside in its contact frame: the sole's corners, edges and middle, or a sphere's lower side.
std::vector<Vector3> UndersideOf(const Foot& foot);

/// How deep the underside may be at both ends, half of what the audit lets pass: it is on its foothold's plane, not on
/// what is tilted or curved beside it [m].
inline constexpr double kSpareDepth = 0.5 * tolerance::kPosition;

/// Share of a swing at each end in which less than the whole clearance is asked for.
inline constexpr double kClearanceEnds = 0.35;

/// What is asked over the ground at a fraction u of the swing, as a share of the clearance: a minimum-jerk rise over
/// the first kClearanceEnds from 0 to 1, and down again over the last. It starts out slower than a foot that lifts off
/// at rest.
double ClearanceRamp(double u);

/// Least height of the underside over the ground, less `clearance_m` times the ramp, over the whole swing: not negative
/// where the swing clears the ground. At both ends half a millimetre less (SwingDepth).
/// @param roll  what the foot rolls off the curve.
double SpareClearance(const SwingCurve& curve, const std::vector<Vector3>& underside_F, const GroundHeight& ground,
                      double clearance_m, const SwingRoll& roll = {});

/// Where the foot can be at a fraction of the swing.
struct ReachAt {
  double u = 0.0;
  std::vector<ReachSide> sides = {};
};

/// What a detour has to keep, and how finely it is sought.
struct RefineChoice {
  double clearance_m = 0.02;
  int control_points = 12;  ///< 9 to 30, three of which are fixed at each end
  int samples = 30;         ///< 20 to 40, at which the clearance is asked for
  double sideways_m = 0.0;  ///< how far to the left of the straight way it passes in mid swing
  SwingRoll roll = {};      ///< what the foot rolls off its curve
  /// Where the foot can be; with any, it may go to the side for it too.
  std::vector<ReachAt> reach = {};
  bool may_stray = false;  ///< where nothing is within reach, what is least out of it
};

/// A swing with a detour and how it came about.
struct RefinedSwing {
  SwingCurve curve;
  double spare_m = 0.0;  ///< SpareClearance
  std::string brief;
};

/// Farthest that a swing is out of reach [m]; not positive where it is within.
double OutOfReach(const SwingCurve& curve, const std::vector<ReachAt>& reach, const SwingRoll& roll = {});

/// The detour, along the way and upwards, and to the side by what is chosen, that makes the jerk's integral of squares
/// least while the underside clears the ground: the foot sets out and arrives without a blow, and its acceleration's
/// peak is near the least there can be. Where its reach is given it is within that too. The ground under the foot, by
/// progress along the way, is looked up once; its steps are taken as steep slopes, as steep as start and end allow, so
/// that the solver feels them coming. Tuning
///   the foot rises too steeply near an edge   more control points, or footholds farther from the edge
///   the sole cuts a corner between samples    more samples
/// Failure kInfeasible says by how much the clearance, or the reach, is missed.
/// @throws InvalidArgument for a number of control points or samples outside of its range.
Result<RefinedSwing> RefineSwing(const SwingCurve& swing, const std::vector<Vector3>& underside_F,
                                 const GroundHeight& ground, const RefineChoice& choice);

}  // namespace gaitwright
