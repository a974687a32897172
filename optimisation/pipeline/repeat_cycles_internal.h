// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "optimisation/trajectory/body_problem_internal.h"
#include "optimisation/whole_body/foot_course_internal.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// Cycles of a plan that are to repeat exactly.
struct RepeatedCycles {
  std::vector<double> time_s;          ///< one in each cycle and one after the last, at the same moment of the gait
  std::vector<CycleTie> displacement;  ///< of the feet from the first of these times to each

  int count() const { return static_cast<int>(time_s.size()) - 1; }
};

/// Those of the steady stretch of each part: the most in a row over which all feet are displaced alike. The plan's
/// cycles are whole numbers of its rows.
std::vector<RepeatedCycles> CyclesToRepeat(const MotionPlan& plan, const std::vector<FootCourse>& courses);

/// Ties the knots at these times (CycleTie). Feet have no rows there, except for the first of each stretch.
/// @param problem  of the plan, with knots at all of these times and a chart that turns by yaw first.
void TieCycles(const std::vector<RepeatedCycles>& all, BodyProblem& problem);

}  // namespace gaitwright
