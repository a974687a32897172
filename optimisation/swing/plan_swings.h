// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/base/options.h"
#include "kinematics/base/result.h"
#include "kinematics/model/robot_model.h"
#include "optimisation/swing/swing_guard.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// Lift of the feet, and search for a detour if the lift is not enough.
///
/// The lift follows the ground: if it is not level under a swing, the foot must keep the full clearance to everything
/// in the middle third of the swing, so it rises before it moves forward to a higher foothold, and moves forward before
/// it descends to a lower one. Towards both ends, less is required (ClearanceRamp), and beside a riser no more than the
/// distance of the footholds: a foothold 5 mm from a riser leaves 5 mm. A swing that is also lifted for a flight must
/// keep an eighth of all that, if possible.
/// Tuning
///   a foot scuffs the edge of a riser    more clearance_m; footholds farther from the edge
///   swings rise too high on rough ground less clearance_m
struct SwingOptions {
  double height_m = 0.0;
  double clearance_m = 0.0;
  int control_points = 12;
  int samples = 30;

  OptionFields Fields() {
    return WithBasics(
        {"height_m", "clearance_m"},
        {{"height_m", &height_m, "m", 0.0, 1.0,
          "Lift of the foot above the straight line between its footholds; 0 uses 0.12 leg lengths, or less if the leg "
          "cannot follow."},
         {"clearance_m", &clearance_m, "m", 0.0, 0.5,
          "Smallest height of the whole sole above ground and obstacles in mid swing; 0 uses a quarter of the lift."},
         {"control_points", &control_points, "1", 9, 30,
          "Number of control points of a swing path that avoids an obstacle."},
         {"samples", &samples, "1", 20, 40,
          "Number of points at which the clearance of an avoiding swing path is checked."}});
  }
};

/// One swing between each two successive footholds of a foot, clear of the ground and of obstacles along the whole
/// curve, for the whole foot and, if the base's motion is given, the leg above it. The closed form is tried first; if
/// the ground is not level, or the swing comes too close to something (less is required towards both ends, see
/// ClearanceRamp), RefineSwing finds a detour, with more clearance if needed; then the lift is raised; then detours to
/// both sides are tried. A detour that the leg can follow within its joint limits and without collision is preferred;
/// otherwise one above the obstacle, which another body height may allow. Sorted by start time, then foot.
/// @param former  base motion and rolling of the feet during swings, from the last whole-body pass; empty if unknown:
///                legs and rolls are then left to the audit.
/// Failure kInfeasible names the foot, the time and the obstacle if no lift up to the leg length and no sideways detour
/// is clear.
Result<std::vector<SwingTrajectory>> PlanSwings(const RobotModel& model, const Terrain& terrain,
                                                const FootstepPlan& footsteps, const SwingOptions& options,
                                                const FormerMotion& former = {});

}  // namespace gaitwright
