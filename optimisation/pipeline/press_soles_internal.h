// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "optimisation/trajectory/body_problem_internal.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// How far inside their edges soles press, so that controllers have room to correct the centre of pressure.
struct SoleMargin {
  double distance_m = 8e-3;
  double share = 0.2;  ///< of the half length and of the half width, at most
};

/// How the feet press at each knot.
using PressingByKnot = std::vector<std::vector<PressingFoot>>;
PressingByKnot PressingOf(const BodyProblem& problem);

/// Moves the points at which soles press inward.
void KeepFromEdges(const SoleMargin& margin, BodyProblem& problem);

/// Whether a motion with little friction may exist near a plan: optimisation halves the horizontal forces at most.
bool MayLowerSoleFriction(const RobotModel& model, const MotionPlan& plan, double friction_use);

/// Lowers the friction of soles to a quarter. What limits it is the moment about their normals: on bumps a sole touches
/// at few points close to each other, and turns long before it slides.
void LowerSoleFriction(BodyProblem& problem);

}  // namespace gaitwright
