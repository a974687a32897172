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

/// The defaults are those of `bench centroidal`. `walk` changes four of them (MotionOptions): the method unless
/// footholds are free; swing_lead_s, because the legs of robots have mass; tolerance and max_refinements, because its
/// passes refine the motion.
///
/// Tuning
///   plans are refined often                   lower spacing_s, raise reach_margin_m
///   friction that is barely sufficient        raise friction_sides
///   infeasible problems take long             lower screening, infeasible
///   a motion that nearly keeps constraints    raise max_penalty
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
  double penalty = 10.0;
  double max_penalty = 100.0;
  int early_check = 40;  ///< option `screening`
  double infeasible = 0.1;
  int max_iterations = 100;
  RigidBodyWeights weights = {.stance = 20.0, .path = 1.0};
  bool turns_by_forces = true;  ///< false: rotation is free, a relaxation that tests the forces

  OptionFields Fields();
};

/// Solver data of a motion.
struct RigidBodySummary {
  int variables = 0, constraints = 0;   ///< of the last solve
  int iterations = 0, refinements = 0;  ///< of all
  double cost = 0.0;
  bool settled = true;      ///< false: satisfies all constraints, but is not optimal
  double violation = 0.0;   ///< largest, in m, rad, rad/s and m g
  double violations = 0.0;  ///< sum of all
  bool least = false;       ///< small changes of the motion do not reduce this sum
  std::string worst;        ///< the constraint with that violation, with place and time
  std::string unmet;        ///< text of all violations for a refusal
  RigidBodyFaults faults;   ///< at 1 kHz
};

/// A stance, and a time between checked ones at which its foot was out of reach.
struct MissedReach {
  std::size_t stance;
  double time_s;
};

/// The solver variables of a motion, as a warm start for similar problems.
struct RigidBodyNumbers {
  std::vector<double> nodes_s;
  std::vector<MissedReach> missed;
  VectorX x;            ///< RigidBodyUnknowns over these nodes
  VectorX multipliers;  ///< of the rows over them (ConstrainedSolution)
};

/// A motion of a rigid body, with solver data.
struct RigidBodyPlan {
  RigidBodyMotion motion;
  RigidBodySummary summary;
  RigidBodyNumbers numbers;
};

/// The motion of least cost (rigid_body_cost.h) under the problem's constraints: force balance exactly, torque balance
/// within the tolerance, friction, footholds in their regions and within reach. Reach also holds shortly before and
/// after a stance, because a foot at rest cannot leave the ground at once: swing_lead_s = v / (2 a) for a body speed v
/// and a foot acceleration a. If violations at 1 kHz, also between nodes, exceed fault_tolerance, it is planned again:
/// with additional reach checks if only reach is violated, else with half the node spacing. Failure kInfeasible
/// `unmet_law` names the violated constraints with place and size, `faults_between` those violated between nodes after
/// all refinements; `last` then has the last state. If the method is `ceres`, the failure is that of ReasonNotCarried
/// if there is one.
/// @throws InvalidArgument as CheckRigidBodyProblem does.
Result<RigidBodyPlan> PlanRigidBody(const RigidBodyProblem& problem, const RigidBodyOptions& options = {},
                                    RigidBodyPlan* last = nullptr);

/// Checks at a fraction of the cost of PlanRigidBody whether forces could carry the body at all with free rotation,
/// free swings and the full reach and friction cones. @return kInfeasible `not_carried` with the violated constraints
/// if violations exceed `infeasible` in all; nothing if a motion may exist.
std::optional<Failure> ReasonNotCarried(const RigidBodyProblem& problem, const RigidBodyOptions& options);

/// As above, warm-started from a motion of a similar problem: the same stances at other times, with nodes at those
/// times. Nodes are not refined, so violations between them other than of reach are refused.
/// @throws InvalidArgument also for nodes that do not fit this problem's times, or another number of variables.
Result<RigidBodyPlan> PlanRigidBodyFrom(const RigidBodyProblem& problem, const RigidBodyOptions& options,
                                        const RigidBodyNumbers& from, RigidBodyPlan* last = nullptr);

}  // namespace gaitwright
