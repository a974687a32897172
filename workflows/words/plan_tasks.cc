// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/words/plan_tasks.h"

#include <fmt/format.h>

#include <algorithm>

#include "kinematics/base/cpu_clock.h"
#include "kinematics/base/version.h"
#include "kinematics/model/load_robot.h"
#include "planning/tasks/task_plan_json.h"
#include "workflows/words/hints.h"
#include "workflows/words/places.h"
#include "workflows/words/task_planner_internal.h"

namespace gaitwright {
namespace {

/// Adds the task's number and words to a failure. @param feet number of feet of the robot: with more than two feet, a
/// step is a footfall of each.
Failure OfTask(std::size_t index, const Task& task, std::size_t feet, Failure failure) {
  const std::string said = task.words.empty() ? TaskText(task) : task.words;
  failure.message = fmt::format("task {}, '{}': {}", index + 1, said, failure.message);
  failure.suggestions = words::SuggestionsInWords(failure.suggestions, feet > 2 ? static_cast<int>(feet) : 1);
  return failure;
}

/// The failure of a plan that fails its audit: the violated check, and the task in which it occurs.
Failure ReasonUnsound(const TaskPlan& tasks, const PlannedTasks& planned) {
  const double at_s = planned.audit.violations.front().at_s;
  const auto& ends_s = planned.task_ends_s;
  const auto within = std::find_if(ends_s.begin(), ends_s.end(), [&](double end_s) { return at_s <= end_s; });
  const std::size_t k =
      std::min<std::size_t>(static_cast<std::size_t>(within - ends_s.begin()), tasks.tasks.size() - 1);
  const Task& task = tasks.tasks[k];
  Failure failure = tasks::ReasonBroken(task.action, planned.audit);
  if (!task.during.empty()) failure.suggestions = {"try the tasks in sequence: 'then' instead of 'while'"};
  return OfTask(k, task, planned.robot.legs.size(), failure);
}

Provenance ProvenanceOf(const TaskPlan& tasks, const TaskOptions& options) {
  MotionOptions motion = options.motion;
  Provenance provenance{Version(), "PlanTasks", {{"tasks", TaskPlanJson(tasks)}}, options.seed};
  for (const auto& [key, text] : TextsOf(motion.Fields())) provenance.options.emplace_back(key, text);
  return provenance;
}

/// The robot with its body as a support contact, if it is to lie or to get up from lying.
Result<RobotModel> WholeRobot(const RobotModel& model, const TaskPlan& tasks, const TaskScope& scope) {
  const bool lies =
      std::any_of(tasks.tasks.begin(), tasks.tasks.end(), [](const Task& task) { return task.action == "lie_down"; });
  const bool gets_up = tasks.tasks.front().action == "stand_up";
  if (!(lies || gets_up) || !scope.Can(*FindAction("lie_down"))) return model;
  std::vector<std::string> links;  // links of the base, the root first
  for (const Shape& shape : model.collision_shapes) {
    if (shape.body == 0 && std::find(links.begin(), links.end(), shape.link) == links.end())
      links.push_back(shape.link);
  }
  Result<RobotModel> whole = model;
  for (const std::string& link : links) {
    whole = WithRest(model, link);
    if (whole) return whole;
  }
  if (!lies) return model;  // gets up from a crouch
  return Failure{FailureKind::kInfeasible,
                 FailureCode::kLying,
                 "PlanTasks",
                 fmt::format("robot '{}' has no flat surface under its body to lie on", model.name),
                 {}};
}

}  // namespace

Result<PlannedTasks> PlanTasks(const RobotModel& model, const Terrain& terrain, const TaskPlan& tasks,
                               const TaskOptions& options) {
  const CpuClock clock;
  TaskScope scope = ScopeOf(model);
  scope.places = PlacesOf(terrain);
  if (auto failure = ReasonNotPlanned(tasks, scope)) return *failure;
  const Result<RobotModel> whole = WholeRobot(model, tasks, scope);
  if (!whole) return whole.failure();
  tasks::TaskPlanner planner(model, *whole, terrain, options);
  if (tasks.tasks.front().action == "stand_up") planner.BeginLow();
  for (std::size_t k = 0; k < tasks.tasks.size(); ++k) {
    if (auto failure = planner.Add(tasks.tasks[k])) return OfTask(k, tasks.tasks[k], model.legs.size(), *failure);
  }
  Result<MotionPlan> plan = planner.Finish();
  if (!plan) return plan.failure();
  PlannedTasks planned;
  planned.robot = *whole;
  planned.plan = std::move(*plan);
  planned.notes = planner.notes();
  planned.task_ends_s = planner.ends_s();
  planned.plan.provenance = ProvenanceOf(tasks, options);
  planned.planning_cpu_s = clock.elapsed_s();
  const Result<AuditReport> audit = Audit(*whole, planned.plan, {});
  if (!audit) return audit.failure();
  planned.audit = *audit;
  if (!audit->pass() && !options.motion.pipeline.allow_limits) return ReasonUnsound(tasks, planned);
  return planned;
}

}  // namespace gaitwright
