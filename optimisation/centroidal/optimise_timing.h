// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "optimisation/centroidal/phase_ties.h"
#include "optimisation/centroidal/plan_rigid_body.h"
#include "optimisation/centroidal/timing_options.h"

namespace gaitwright {

/// A motion with optimised timing.
struct TimedPlan {
  RigidBodyProblem problem;  ///< with its stances at the optimised times
  RigidBodyPlan plan;
  double first_cost = 0.0;  ///< of the first motion, at the given times or the first feasible ones
  bool mended = false;      ///< the given times had no feasible motion
  int steps = 0;            ///< improvements of the durations
  int solves = 0;           ///< number of solves, including refused ones, without the first motion
  VectorX parts_s;          ///< durations of the parts, if phases are tied
};

/// Optimises the durations of a motion's phases (SwitchTimes) within bounds, with fixed or free total time, by a local
/// search. The order of contact switches is kept, and simultaneous ones stay simultaneous. Each step follows the
/// derivative of the optimal cost by the durations (cost_by_durations.h) with a curvature from former steps (damped
/// BFGS; Nocedal and Wright, 2006, procedure 18.2), limited by a trust region relative to each duration, and is planned
/// from the last motion; it is accepted only if the motion satisfies all constraints, also at 1 kHz, and costs less. If
/// the given times have no feasible motion, steps follow the derivative of the constraint penalty until there is one.
/// Legs have no mass here, so swing durations need a bound: no swing becomes shorter than shortest_swing_s, or its
/// given duration if that is less; each of its phases keeps at least its share of that. At the end, if the optimised
/// times need more nodes, these are placed again, provided that the motion over them costs no more.
///
/// The cost is an integral over time: with free total time, a shorter time reduces terms that are integrated over
/// time, and a longer time reduces forces; compare costs of different total times with care.
///
/// Failures: those of PlanRigidBody, if other times do not help; kInfeasible `no_timing` if the sum of the shortest
/// durations exceeds the longest total, or the sum of the longest is below the shortest total; kBadInput `no_duration`
/// if a shortest duration exceeds the longest, `tied_to_time` for leg angular momentum, motor limits or clearances,
/// which belong to given times.
/// @throws InvalidArgument as CheckRigidBodyProblem does, and for invalid options.
/// @param first  if given: the motion at the given times, with the same options. It is planned again if some of these
///               times are out of bounds and are moved to the bounds.
/// @param ties   if given: durations of phases follow from those of fewer parts, which are then the variables. The sum
///               of the parts and the total time are kept; bounds are the longest_s of the options and those of the
///               ties.
Result<TimedPlan> OptimiseTiming(const RigidBodyProblem& problem, const RigidBodyOptions& planning = {},
                                 const TimingOptions& options = {}, const RigidBodyPlan* first = nullptr,
                                 const PhaseTies* ties = nullptr);

}  // namespace gaitwright
