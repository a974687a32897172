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

/// How tasks are planned.
struct TaskOptions {
  MotionOptions motion;
  std::uint64_t seed = 0;
};

/// The motion that does a plan of tasks, its audit, and what was settled on the way.
struct PlannedTasks {
  RobotModel robot;  ///< the one that the motion is of: where it lies, with what it lies on
  MotionPlan plan;
  AuditReport audit;
  std::vector<std::string> notes;   ///< what was added or chosen that no words say, for people
  std::vector<double> task_ends_s;  ///< of each task, on the plan's clock
  double planning_cpu_s = 0.0;
};

/// Plans tasks one after the other, as one motion that passes its audit.
///
/// Walks are planned as PlanWalk does, each from where the task before leaves the robot. All else is a posture motion
/// (planning/tasks/repertoire.h): it is stretched until motors and balance allow it, and sized as the task says, or
/// where it says nothing as the robot can. A robot that sits or lies gets up before it does what is done standing; one
/// that can lie and is to stand up first begins lying.
/// Raised arms stay up until they are lowered.
///
///   walk   without an amount three leg lengths far; slow and fast are half and one and a half of the robot's own speed
///   steps  of a robot with more than two legs: of all its legs
///   turn   a quarter without an angle
///   to     straight there, after a turn where it is not ahead
///
/// Failures: those of WhyNotPlanned, PlanWalk and PlanPosture, with the task's number and words; kInfeasible for what
/// breaks a law of the audit however slow, with the largest size that does not where a size was asked for.
Result<PlannedTasks> PlanTasks(const RobotModel& model, const Terrain& terrain, const TaskPlan& tasks,
                               const TaskOptions& options);

}  // namespace gaitwright
