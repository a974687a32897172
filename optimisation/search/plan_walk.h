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

/// How long a sound plan is looked for.
struct SearchOptions {
  int max_plans = 400;

  OptionFields Fields() {
    return WithBasics(
        {}, {{"max_plans", &max_plans, "1", 1, 100000,
              "Largest number of candidates (pace, cycle, flight) that are planned before a walk is refused."}});
  }
};

/// What is asked of PlanWalk.
struct WalkRequest {
  std::string gait;  ///< "" for the robot's best
  std::string terrain = "flat";
  WalkCommand command;
  bool own_pace = false;  ///< nobody asked for the command's speed: see PlanWalk; of commands without one it is true
  std::string sequence;   ///< parts one after the other in place of the gait and command, see ReadSequence; or ""
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

/// Plans and audits. A walk whose plan fails its audit is planned again with quicker or slower steps as far as the
/// gait's own time may change; when that does not help either, failure kInfeasible names what forbids it, the robot's
/// worst limit before laws of the ground (dynamics, friction, support), by how much it is passed, and the largest
/// speed, turning rate or step length of the same walk that has a plan; where the speed is the robot's own, that walk
/// is given. Both are looked for on the start of the walk and then tried on the whole. With `pipeline.allow_limits` the
/// first plan is given all the same, with the audit's verdict; so is in any case one whose only fault is a shank in the
/// ground beside the foot at its end, which no pace mends. A sequence is planned in one motion; a part that has no plan
/// is named.
/// @param trace  where each plan that was tried is added, unless null.
Result<PlannedWalk> PlanWalk(const RobotModel& model, const WalkRequest& request, SearchTrace* trace = nullptr);

/// PlanWalk on a given ground; the request's `terrain` is only written into the plan.
Result<PlannedWalk> PlanWalkOn(const RobotModel& model, const Terrain& terrain, const WalkRequest& request,
                               SearchTrace* trace = nullptr);

/// What shapes a plan besides its command and seed: gait, ground and sequence by name (of a file its name alone, since
/// a plan holds no path), and the options. The request must outlive the fields.
OptionFields RequestFields(WalkRequest& request);

}  // namespace gaitwright
