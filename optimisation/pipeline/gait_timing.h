// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/base/result.h"
#include "optimisation/pipeline/plan_motion.h"

namespace gaitwright {

/// Gaits whose times within the cycle cost a walk less, and what that took.
struct TimedGaits {
  std::vector<WalkPart> parts;
  double cost_before = 0.0, cost = 0.0;  ///< of the rigid body's motion; summed over the gaits that were optimised
  int solves = 0;
};

/// Makes the times within the cycle variables of each gait that is planned as the motion of a rigid body: of stances,
/// flights and of feet after each other. The cycle, the speed and the time of the whole walk stay, so that all cycles
/// are alike; no swing is shorter than 0.7 of its time or options.timing_bounds.shortest_swing_s. The robot is one
/// rigid body on legs without mass here (OptimiseTiming, with the robot's inertia, workspaces, footholds and swings).
/// Failures: those of PlanSequence and OptimiseTiming; kInfeasible `no_timing` where no part has times to optimise.
Result<TimedGaits> OptimiseGaits(const RobotModel& model, const Terrain& terrain, const std::vector<WalkPart>& parts,
                                 const MotionOptions& options);

/// PlanMotion with the gaits of OptimiseGaits, where that makes a better motion of the whole robot (IsBetterMotion).
/// Changes half as great are tried after the whole ones. Else the plan at the gaits' own times. The plan's adjustments
/// say what changed.
Result<PlannedMotion> PlanAtBestTimes(const RobotModel& model, const Terrain& terrain,
                                      const std::vector<WalkPart>& parts, const MotionOptions& options);

}  // namespace gaitwright
