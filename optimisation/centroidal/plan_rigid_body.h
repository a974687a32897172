// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kinematics/base/options.h"
#include "kinematics/base/result.h"
#include "optimisation/centroidal/rigid_body_cost.h"
#include "optimisation/centroidal/rigid_body_motion.h"
#include "optimisation/centroidal/rigid_body_problem.h"

namespace gaitwright {

/// The defaults are those of `walk` and of `bench centroidal`, of which `walk` changes two (MotionOptions): the method
/// while footholds are free, and swing_lead_s, since the legs of robots have mass.
///
/// Tuning
///   plans are refined often                   lower spacing_s, raise reach_margin_m
///   friction that only just suffices          raise friction_sides
///   much is spent on what has no motion        lower screening, hopeless
///   a motion that all but keeps its laws      raise most_price
struct RigidBodyOptions {
  std::string method = "interior-point";
  double spacing_s = 0.04;
  int least_intervals = 3;
  double grid_s = 0.0;
  int friction_sides = 8;
  double force_margin = 0.01;
  double reach_margin_m = 1e-3;
  double swing_lead_s = 0.0125;
  double tolerance = 1e-5;
  double fault_tolerance = 1e-3;
  int max_refinements = 4;
  double cost_tolerance = 1e-3;
  double price = 10.0;
  double most_price = 100.0;
  int screening = 40;
  double hopeless = 0.1;
  int max_iterations = 100;
  RigidBodyWeights weights = {.stance = 20.0, .way = 1.0};
  bool turns_by_forces = true;  ///< else it may turn as it likes, which is no motion but tells what forces cannot do

  OptionFields Fields();
};

/// How a motion was found.
struct RigidBodySummary {
  int variables = 0, constraints = 0;   ///< of the last solve
  int iterations = 0, refinements = 0;  ///< of all
  double cost = 0.0;
  bool settled = true;      ///< else the motion is one that keeps all laws, but not the least costly one
  bool gave_up = false;     ///< the method asked for kept not all laws, so that the interior-point method went on
  double violation = 0.0;   ///< largest, in m, rad, rad/s and m g
  double violations = 0.0;  ///< sum of all
  bool least = false;       ///< that sum does not get less by small changes of the motion
  std::string worst;        ///< the law with that violation, where and when
  std::string unmet;        ///< what a refusal says of all that is violated
  RigidBodyFaults faults;   ///< at 1 kHz
};

/// A stance and a time at which its foot was out of reach between those at which it was looked at.
struct MissedReach {
  std::size_t stance;
  double time_s;
};

/// The numbers that a motion was found as, from which one like it can be found.
struct RigidBodyNumbers {
  std::vector<double> breaks_s;
  std::vector<MissedReach> missed;
  VectorX x;            ///< RigidBodyUnknowns over these breaks
  VectorX multipliers;  ///< of the rows over them (ConstrainedSolution)
};

/// A motion of a rigid body and how it was found.
struct RigidBodyPlan {
  RigidBodyMotion motion;
  RigidBodySummary summary;
  RigidBodyNumbers numbers;
};

/// The motion of least cost (rigid_body_cost.h) that keeps the laws of the problem: balance of forces exactly and that
/// of torques by the stated tolerance, friction, footholds in their regions and within reach; these a little before and
/// after their stances too, since a foot at rest on the ground cannot leave it at once: swing_lead_s = v / (2 a) for a
/// body of speed v and feet of acceleration a. Where its faults at 1 kHz, between breaks too, are over fault_tolerance,
/// it is planned anew: where feet alone are out of reach, from there on with those times looked at too, else with
/// breaks half as far apart. Failure kInfeasible `unmet_law` names what stays unmet, where and
/// by how much, `faults_between` what breaks cannot be near enough for; `last` then holds where it stood.
/// @throws InvalidArgument as CheckRigidBodyProblem.
Result<RigidBodyPlan> PlanRigidBody(const RigidBodyProblem& problem, const RigidBodyOptions& options = {},
                                    RigidBodyPlan* last = nullptr);

/// Looks before PlanRigidBody whether forces could carry the body along at all, were it to turn as it likes, swing its
/// feet anyhow and go to the ends of its reach and cones: for a tenth of the time. @return kInfeasible `not_carried`
/// with what stays unmet, where and by how much, where violations come to more than `hopeless` in all; nothing where
/// there may be a motion. Where another method than interior-point is to plan, the problem as it is is looked at by
/// that too, and `unmet_law` said where violations come to five times as much.
std::optional<Failure> WhyNotCarried(const RigidBodyProblem& problem, const RigidBodyOptions& options);

/// The same from the numbers of a motion of a problem like this one: the same stances at times of their own, and breaks
/// at those times. Breaks stay where they are, so that faults between them other than of reach are refused.
/// @throws InvalidArgument also for breaks that are not those of this problem's times, or another count of numbers.
Result<RigidBodyPlan> PlanRigidBodyFrom(const RigidBodyProblem& problem, const RigidBodyOptions& options,
                                        const RigidBodyNumbers& from, RigidBodyPlan* last = nullptr);

}  // namespace gaitwright
