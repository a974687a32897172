// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "kinematics/base/options.h"
#include "kinematics/base/result.h"
#include "kinematics/model/robot_model.h"
#include "optimisation/pipeline/plan_motion.h"
#include "optimisation/search/search_trace.h"
#include "planning/audit/audit.h"
#include "planning/gait/find_gait.h"

namespace gaitwright {

/// Budget of the search for a sound plan.
struct SearchOptions {
  int max_plans = 400;

  OptionFields Fields() {
    return WithBasics(
        {}, {{"max_plans", &max_plans, "1", 1, 100000,
              "Maximum number of candidates (speed, cycle, flight) that are planned before a walk is refused."}});
  }
};

/// Request for PlanWalk.
struct WalkRequest {
  std::string gait;  ///< empty for the robot's best gait
  std::string terrain = "flat";
  WalkCommand command;
  bool own_pace = false;  ///< the caller gave no speed, so PlanWalk may lower it; set for commands without a speed
  std::string sequence;   ///< consecutive parts that replace gait and command, see ReadSequence; may be empty
  GaitOptions gait_options;
  SearchOptions search;
  MotionOptions motion;
  std::uint64_t seed = 0;

  OptionFields Fields() {
    return Joined({Prefixed("gait", gait_options.Fields()), Prefixed("search", search.Fields()), motion.Fields()});
  }
};

/// A plan, its audit, and the CPU time of planning without the audit.
struct PlannedWalk {
  PlannedMotion motion;
  AuditReport audit;
  double planning_cpu_s = 0.0;
};

/// Plans a walk and audits the plan. If the plan fails its audit, the walk is planned again with shorter or longer
/// cycles, if the request allows another cycle. If that does not help, the failure kInfeasible names the violated limit
/// or check and by how much it is violated: the robot's worst limit, or otherwise a check of dynamics, friction or
/// support. It also names the largest speed, turning rate or step length of the same walk that has a plan; if the speed
/// is the robot's default, that walk is returned instead. Cycles and speeds are searched on the start of the walk and
/// then tried on the whole walk. With `pipeline.allow_limits` the first plan is returned in any case, with the audit's
/// verdict. A plan whose only fault is a shank in the ground beside its foot at the end is also returned, because no
/// speed corrects that. A sequence is planned in one motion; the failure names a part without a plan.
/// @param trace  receives each plan that was tried; may be null.
Result<PlannedWalk> PlanWalk(const RobotModel& model, const WalkRequest& request, SearchTrace* trace = nullptr);

/// PlanWalk on a given ground; the request's `terrain` is only written into the plan.
Result<PlannedWalk> PlanWalkOn(const RobotModel& model, const Terrain& terrain, const WalkRequest& request,
                               SearchTrace* trace = nullptr);

/// Everything besides command and seed that shapes a plan: gait, ground and sequence by name (files without their
/// path), and the options. The request must outlive the fields.
OptionFields RequestFields(WalkRequest& request);

}  // namespace gaitwright
