// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "kinematics/base/options.h"
#include "kinematics/base/result.h"
#include "optimisation/centroidal/zmp_problem.h"

namespace gaitwright {

/// Planner of the centre of mass, and requirements on the ZMP.
struct CentreOfMassOptions {
  std::string method = "optimised";
  double zmp_margin_m = 0.0;
  double centre_weight = 1.0;
  double smooth_weight = 1e-4;
  double knot_spacing_s = 0.25;
  double preview_s = 1.6;
  double preview_jerk_weight = 1e-6;

  OptionFields Fields() {
    return WithBasics(
        {"method", "zmp_margin_m"},
        {{"method",
          &method,
          "",
          0.0,
          0.0,
          "Planner of the centre of mass: optimised ZMP, closed form, preview control, or rigid body with contact "
          "forces. Gaits with flight always use rigid-body.",
          {"optimised", "closed-form", "preview", "rigid-body"}},
         {"zmp_margin_m", &zmp_margin_m, "m", 0.0, 0.2,
          "Smallest distance from the planned ZMP to the edge of its support region, or to the ends of a line "
          "support."},
         {"centre_weight", &centre_weight, "1/(m^2 s)", 1e-6, 1e6,
          "Cost weight of the squared distance between the ZMP and its preferred point, integrated over time."},
         {"knot_spacing_s", &knot_spacing_s, "s", 0.02, 1.0,
          "Longest time between two knots of the ZMP spline; each phase that is long enough has an inner knot."},
         {"preview_s", &preview_s, "s", 0.1, 5.0,
          "Horizon of preview control; the plan stands longer by this time at both ends."},
         {"preview_jerk_weight", &preview_jerk_weight, "s^6/m^2", 1e-12, 1.0,
          "Cost weight of the squared jerk in preview control; the squared ZMP error has weight 1."},
         {"smooth_weight", &smooth_weight, "s/m^2", 0.0, 1e6,
          "Cost weight of the squared rate of the ZMP, integrated over time."}});
  }
};

/// The centre of mass of the pendulum under a ZMP in its supports that makes it start and end at rest.
///   optimised    OptimiseZmp: near its preferred points and smooth; if it fails, the closed form if that stays in the
///                supports
///   closed-form  at its preferred points, moved in the first and last phase as little as needed to start and end at
///                rest
///   preview      PreviewZmp, moved in the same way
/// Failure kInfeasible names the phase in which the ZMP would leave its region, and by how much.
Result<CentreOfMassPlan> PlanCentreOfMass(const ZmpProblem& problem, const CentreOfMassOptions& options);

}  // namespace gaitwright
