// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/base/result.h"
#include "optimisation/pipeline/plan_motion.h"

namespace gaitwright {

/// Gaits with optimised times within the cycle, with the costs.
struct TimedGaits {
  std::vector<WalkPart> parts;
  double cost_before = 0.0, cost = 0.0;  ///< of the rigid body's motion; summed over the optimised gaits
  int solves = 0;
};

/// Optimises the times within the cycle of each gait that is planned as the motion of a rigid body: durations of
/// stances and flights, and delays between feet. The cycle time, the speed and the duration of the walk are constant,
/// and all cycles are alike. No swing is shorter than 0.7 of its time or options.timing_bounds.shortest_swing_s. The
/// model is one rigid body on massless legs (OptimiseTiming, with the robot's inertia, workspaces, footholds and
/// swings).
/// Failures: those of PlanSequence and OptimiseTiming; kInfeasible `no_timing` if no part has times to optimise.
Result<TimedGaits> OptimiseGaits(const RobotModel& model, const Terrain& terrain, const std::vector<WalkPart>& parts,
                                 const MotionOptions& options);

/// PlanMotion with the gaits of OptimiseGaits, if that gives a better motion of the whole robot (IsBetterMotion). If
/// the full changes do not, half of them are tried; otherwise it returns the plan with the gaits' own times. The plan's
/// adjustments list the changes.
Result<PlannedMotion> PlanAtBestTimes(const RobotModel& model, const Terrain& terrain,
                                      const std::vector<WalkPart>& parts, const MotionOptions& options);

}  // namespace gaitwright
