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

/// Accepted depth of the underside at both ends, half of the audit's tolerance: it lies on its foothold's plane, not on
/// tilted or curved ground beside it [m].
inline constexpr double kDepthMargin = 0.5 * tolerance::kPosition;

/// Share of a swing at each end in which less than the full clearance is required.
inline constexpr double kClearanceEnds = 0.35;

/// Required share of the clearance at a fraction u of the swing: a minimum-jerk rise from 0 to 1 over the first
/// kClearanceEnds, and down again over the last. It starts more slowly than a foot that lifts off at rest.
double ClearanceRamp(double u);

/// Smallest height of the underside above the ground minus `clearance_m` times the ramp, over the whole swing: not
/// negative if the swing clears the ground. At both ends half a millimetre less (SwingDepth).
/// @param roll  offset of the foot from the curve by rolling.
double ClearanceMargin(const SwingCurve& curve, const std::vector<Vector3>& underside_F, const GroundHeight& ground,
                       double clearance_m, const SwingRoll& roll = {});

/// Smallest height of the underside above the ground in the middle of the swing, without kClearanceEnds at each end
/// [m].
double MidSwingClearance(const SwingCurve& curve, const std::vector<Vector3>& underside_F, const GroundHeight& ground,
                         const SwingRoll& roll = {});

/// Reach of the foot at a fraction of the swing.
struct ReachAt {
  double u = 0.0;
  std::vector<ReachSide> sides = {};
};

/// Requirements on a detour, and resolution of its search.
struct RefineChoice {
  double clearance_m = 0.02;
  int control_points = 12;  ///< 9 to 30, three of which are fixed at each end
  int samples = 30;         ///< 20 to 40, at which the clearance is checked
  double sideways_m = 0.0;  ///< lateral offset (to the left) from the straight path in mid swing
  SwingRoll roll = {};      ///< offset of the foot from its curve by rolling
  /// Reach of the foot; if given, the detour may also move sideways to stay within it.
  std::vector<ReachAt> reach = {};
  bool may_stray = false;  ///< if no detour is within reach, return the one closest to it
};

/// A swing with a detour, with solver data.
struct RefinedSwing {
  SwingCurve curve;
  double margin_m = 0.0;  ///< ClearanceMargin
  std::string brief;
};

/// Largest distance of a swing out of reach [m]; not positive if within reach.
double OutOfReach(const SwingCurve& curve, const std::vector<ReachAt>& reach, const SwingRoll& roll = {});

/// The detour, forward and upward with a given sideways offset, that minimises the integral of squared jerk while the
/// underside clears the ground: the foot starts and lands without impact, and its peak acceleration is nearly minimal.
/// If the reach is given, the detour stays within it. The ground profile along the path is sampled once; its steps are
/// replaced by slopes, as steep as start and end allow, so the solver has gradients.
/// Tuning
///   the foot rises too steeply near an edge   more control points, or footholds farther from the edge
///   the sole cuts a corner between samples    more samples
/// Failure kInfeasible names the missing clearance or reach.
/// @throws InvalidArgument for a number of control points or samples outside its range.
Result<RefinedSwing> RefineSwing(const SwingCurve& swing, const std::vector<Vector3>& underside_F,
                                 const GroundHeight& ground, const RefineChoice& choice);

}  // namespace gaitwright
