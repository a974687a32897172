// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "optimisation/centroidal/plan_rigid_body.h"

namespace gaitwright {

/// Tuning
///   phases of the gait become too short or long     raise shortest_s, lower longest_s
///   legs cannot swing as fast as that               raise shortest_swing_s
///   the total time is too short or too long         raise most_total, lower least_total
///   cost could fall further                         lower least_gain, raise max_solves
///   motions from one step to the next are refused   lower first_change, most_change
struct TimingOptions {
  double shortest_s = 0.03;
  double longest_s = 5.0;
  double shortest_swing_s = 0.15;
  double least_total = 1.0;
  double most_total = 1.0;
  double first_change = 0.2;
  double most_change = 0.5;
  double least_gain = 1e-2;
  int max_solves = 12;

  OptionFields Fields();
};

/// A motion with optimised timing.
struct TimedPlan {
  RigidBodyProblem problem;  ///< with its stances at the optimised times
  RigidBodyPlan plan;
  double first_cost = 0.0;  ///< of the first motion, at the given times or the first feasible ones
  bool mended = false;      ///< the given times had no feasible motion
  int steps = 0;            ///< improvements of the durations
  int solves = 0;           ///< number of solves, including refused ones, without the first motion
};

/// Optimises the durations of a motion's phases (SwitchTimes) within bounds, with fixed or free total time, by a local
/// search. The order of contact switches is kept, and simultaneous ones stay simultaneous. Each step follows the
/// derivative of the optimal cost by the durations (cost_by_durations.h) with a curvature from former steps (damped
/// BFGS; Nocedal and Wright, 2006, procedure 18.2), limited by a trust region relative to each duration, and is planned
/// from the last motion; it is accepted only if the motion satisfies all constraints, also at 1 kHz, and costs less. If
/// the given times have no feasible motion, steps follow the derivative of the constraint penalty until there is one.
/// Legs have no mass here, so swing durations need a bound: none becomes shorter than shortest_swing_s, or than its
/// given duration if that is less; each of its phases keeps at least its share of that. At the end, if the optimised
/// times need more nodes, these are placed again, provided that the motion over them costs no more.
///
/// The cost is an integral over time: with free total time, a shorter time reduces terms that are integrated over
/// time, and a longer time reduces forces; compare costs of different total times with care.
///
/// Failures: those of PlanRigidBody, if other times do not help; kInfeasible `no_timing` if the sum of the shortest
/// durations exceeds the longest total, or the sum of the longest is below the shortest total; kBadInput `no_duration`
/// if a shortest duration exceeds the longest, `tied_to_time` for leg angular momentum or motor limits, which belong to
/// given times.
/// @throws InvalidArgument as CheckRigidBodyProblem, and for invalid options.
/// @param first  if given: the motion at the given times, with the same options. It is planned again if some of these
///               times are out of bounds and are moved to the bounds.
Result<TimedPlan> OptimiseTiming(const RigidBodyProblem& problem, const RigidBodyOptions& planning = {},
                                 const TimingOptions& options = {}, const RigidBodyPlan* first = nullptr);

}  // namespace gaitwright
