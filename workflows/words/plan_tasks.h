// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "kinematics/model/robot_model.h"
#include "planning/audit/audit.h"
#include "planning/plan/motion_plan.h"
#include "planning/tasks/task_plan.h"
#include "planning/tasks/task_rules.h"
#include "workflows/walk/walk.h"

namespace gaitwright {

/// Options of planning tasks.
struct TaskOptions {
  MotionOptions motion;
  std::uint64_t seed = 0;
};

/// The motion for a task plan, its audit, and notes.
struct PlannedTasks {
  RobotModel robot;  ///< robot of the motion; if it lies, with the body as a support contact
  MotionPlan plan;
  AuditReport audit;
  std::vector<std::string> notes;   ///< notes on everything that was added or chosen beyond the words
  std::vector<double> task_ends_s;  ///< end of each task, on the plan's clock
  double planning_cpu_s = 0.0;
};

/// Plans tasks in sequence, as one motion that passes its audit.
///
/// Walks are planned by PlanWalk, each from the end of the previous task. All other tasks are posture motions
/// (planning/tasks/repertoire.h). A posture motion is slowed down until motors and balance allow it. Its size is that
/// of the task, or the robot's default. A robot that sits or lies gets up before a task that is done standing. A robot
/// that can lie and must first stand up begins in a lying posture.
/// Raised arms stay up until they are lowered.
///
///   walk   default distance: three leg lengths; slow and fast: 0.5 and 1.5 times the robot's default speed
///   steps  with more than two legs, one step is a footfall of each leg
///   turn   default angle: a quarter turn
///   to     straight to the place, after a turn if the place is not in front
///
/// Failures: as of ReasonNotPlanned, PlanWalk and PlanPosture, with the task's number and words; kInfeasible for a
/// motion that fails its audit at any speed, with the largest feasible size if a size was requested.
Result<PlannedTasks> PlanTasks(const RobotModel& model, const Terrain& terrain, const TaskPlan& tasks,
                               const TaskOptions& options);

}  // namespace gaitwright
