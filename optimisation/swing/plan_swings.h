// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/base/options.h"
#include "kinematics/base/result.h"
#include "kinematics/model/robot_model.h"
#include "optimisation/swing/swing_guard.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// How high feet are lifted, and how a detour is sought where that is not enough.
///
/// The lift follows the ground: where it is not level under a swing, the foot is asked to keep the whole clearance over
/// everything from the first third of the swing to the last, so that from a lower foothold to a higher one it rises
/// before it goes ahead, and goes ahead before it comes down where the way leads down. Towards both ends less is asked
/// for (ClearanceRamp), and to the side of a riser no more than the foot has beside its footholds: a foothold 5 mm from
/// a riser leaves 5 mm. What is lifted for the body's flight too is asked for an eighth of all that, where it can be
/// had. Tuning
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
/// curve, for the whole foot and, where the base's motion is given, the leg above it. The closed form first; where the
/// ground is not level, or it comes too near to something (less is asked towards both ends, see ClearanceRamp),
/// RefineSwing finds a detour, with more clearance if need be; then the lift is raised; then ways to either side are
/// tried. A detour that the leg can follow within its joints' limits, and that leaves the leg clear, is
/// preferred; where there is none, one over what is in the way, which another height of the body may follow.
/// Sorted by start time, then foot.
/// @param former  where the base is while the feet swing, and what they roll in the air, as of the last pass over the
///                whole body; empty where that is not known: legs and rolls are then left to the audit.
/// Failure kInfeasible names the foot, the time, and what is hit when no lift up to the leg's length and no way to the
/// side clears.
Result<std::vector<SwingTrajectory>> PlanSwings(const RobotModel& model, const Terrain& terrain,
                                                const FootstepPlan& footsteps, const SwingOptions& options,
                                                const FormerMotion& former = {});

}  // namespace gaitwright
