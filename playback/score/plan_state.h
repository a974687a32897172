// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// What a plan says of one instant.
struct PlanState {
  VectorX q, v, a, tau;
  std::vector<ContactWrench> wrenches;  ///< by foot; empty when the plan has none
};

/// The plan between its rows: cubic Hermite for positions, spherical-linear for the orientation, linear for the rest;
/// held at its ends. @throws InvalidArgument when the plan has no rows.
PlanState PlanStateAt(const WholeBodyTrajectory& motion, double time_s);

}  // namespace gaitwright
