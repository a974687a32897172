// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "optimisation/centroidal/phase_ties.h"
#include "optimisation/centroidal/plan_rigid_body.h"
#include "optimisation/centroidal/timing_options.h"

namespace gaitwright {

/// A motion at times that suit it.
struct TimedPlan {
  RigidBodyProblem problem;  ///< with its stances at these times
  RigidBodyPlan plan;
  double first_cost = 0.0;  ///< of the first motion, at the times that were given or those that mended it
  bool mended = false;      ///< there was no motion at the times that were given
  int steps = 0;            ///< from one set of durations to a better one
  int solves = 0;           ///< that this took, refused ones too, without that of the first motion
  VectorX parts_s;          ///< where phases are tied: the durations of their parts
};

/// Makes the durations of a motion's phases (SwitchTimes) variables, within bounds, with the total time given or free,
/// and finds ones of less cost nearby. Contacts begin and end in the order that they have, and those that do so
/// together stay together. Each step goes along the slope of the least cost by the durations (cost_by_durations.h) with
/// a curvature learnt from former steps (damped BFGS; Nocedal and Wright, 2006, procedure 18.2), no farther than a
/// share of each duration that follows how well former steps did, and is planned from the last motion; it is taken only
/// if the motion keeps all laws, at 1 kHz too, and costs less, so that what has a motion keeps one and costs no more.
/// Where there is no motion at the times that are given, steps go along the slope of what is paid for the violation of
/// laws, until there is one.
/// Legs have no mass here, so that nothing else keeps swings from being hurried: none becomes shorter than
/// shortest_swing_s, or than it is given where that is less; each phase of it keeps its share of that at least.
/// At the end, where the times that were found ask for more breaks, these are placed anew if the motion over them costs
/// no more.
///
/// The cost is an integral over time: with the total time free, less of it may mean less of what is weighed by time,
/// and more of it weaker forces; costs of different totals are of motions that take as long as they do.
///
/// Failures: those of PlanRigidBody, where other times do not mend them; kInfeasible `no_timing` where the shortest
/// phases together are longer than the greatest total, or the longest shorter than the least; kBadInput `no_duration`
/// where a shortest duration is longer than the longest, `tied_to_time` for inner momentum or limits of motors, which
/// belong to given times and are to be found anew for others.
/// @throws InvalidArgument as CheckRigidBodyProblem, and for options that are none.
/// @param first  if given: the motion at the times that are given, of the same options. It is planned anew where some
///               of these times are out of bounds and brought to the nearest ones that are not.
/// @param ties   if given: durations of phases follow from those of fewer parts, which are the variables then. The sum
///               of the parts and the total time stay; bounds are the longest_s of the options and those of the ties.
Result<TimedPlan> OptimiseTiming(const RigidBodyProblem& problem, const RigidBodyOptions& planning = {},
                                 const TimingOptions& options = {}, const RigidBodyPlan* first = nullptr,
                                 const PhaseTies* ties = nullptr);

}  // namespace gaitwright
