// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/base/options.h"
#include "kinematics/base/result.h"
#include "optimisation/centroidal/zmp_problem.h"

namespace gaitwright {

struct CentreOfMassOptions {
  double zmp_margin_m = 0.0;

  OptionFields Fields() {
    return {{"zmp_margin_m",
             &zmp_margin_m,
             "m",
             0.0,
             0.2,
             "Least distance of the planned ZMP to the edge of a support that has area.",
             {}}};
  }
};

/// The ZMP at its preferred points, moved in the first and last phase as little as makes the pendulum start and end at
/// rest. Failure kInfeasible names the phase in which the ZMP would leave its region, and by how much.
Result<CentreOfMassPlan> PlanCentreOfMass(const ZmpProblem& problem, const CentreOfMassOptions& options);

}  // namespace gaitwright
