// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "planning/tasks/task_plan.h"
#include "planning/tasks/task_plan_json.h"
#include "python/bindings/bindings.h"
#include "python/bindings/errors.h"
#include "python/bindings/options.h"
#include "python/bindings/plan.h"
#include "python/bindings/terrain.h"
#include "workflows/words/interpret.h"
#include "workflows/words/places.h"
#include "workflows/words/plan_tasks.h"

namespace gaitwright::python {
namespace {

namespace py = pybind11;

TaskScope ScopeOn(const RobotModel& model, const Terrain& terrain) {
  TaskScope scope = ScopeOf(model);
  scope.places = PlacesOf(terrain);
  return scope;
}

/// Reads words, or a task plan as `understand` returns it.
TaskPlan TasksIn(const py::object& what, const TaskScope& scope) {
  if (py::isinstance<py::str>(what)) return Value(Interpret(what.cast<std::string>(), scope, std::nullopt)).plan;
  if (!py::isinstance<py::dict>(what))
    throw py::type_error(fmt::format("the task is {}; accepted: an instruction as text, or a task plan as a dictionary",
                                     py::repr(what).cast<std::string>()));
  TaskPlan plan = Value(TaskPlanFromJson(py::module_::import("json").attr("dumps")(what).cast<std::string>()));
  if (auto failure = ReasonNotPlanned(plan, scope)) throw FailureError(*failure);
  return plan;
}

py::object Understand(const SharedRobot& robot, const std::string& words, const py::object& terrain) {
  const TaskPlan plan = TasksIn(py::str(words), ScopeOn(*robot, TerrainOf(terrain, *robot)));
  return py::module_::import("json").attr("loads")(TaskPlanJson(plan));
}

std::pair<std::shared_ptr<Plan>, std::vector<std::string>> PlanWhat(const SharedRobot& robot, const py::object& what,
                                                                    const py::object& terrain, std::uint64_t seed,
                                                                    const py::dict& options) {
  TaskOptions task_options;
  task_options.seed = seed;
  SetOptions(task_options.motion.Fields(), options);
  const Terrain ground = TerrainOf(terrain, *robot);
  const TaskPlan tasks = TasksIn(what, ScopeOn(*robot, ground));
  const py::gil_scoped_release others_go_on;
  PlannedTasks planned = Value(PlanTasks(*robot, ground, tasks, task_options));
  auto of_motion = std::make_shared<RobotModel>(std::move(planned.robot));
  return {std::make_shared<Plan>(std::move(of_motion), std::move(planned.plan)), std::move(planned.notes)};
}

}  // namespace

void BindTasks(py::module_& module) {
  module.def(
      "understand", Understand, py::arg("robot").none(false), py::arg("words"), py::kw_only(),
      py::arg("terrain") = "flat",
      R"(Translates an instruction in English or Chinese to a task plan, with the built-in grammar (docs/words.md).

Raises:
    BadInputError: the instruction is not understood, or this robot cannot do it; the message names alternatives.)");
  module.def("plan_tasks", PlanWhat, py::arg("robot").none(false), py::arg("what"), py::kw_only(),
             py::arg("terrain") = "flat", py::arg("seed") = 0, py::arg("options") = py::dict(),
             R"(Plans one motion that does several tasks in sequence, and audits it.

Args:
    what: words, such as "stand up, then walk two steps and wave", or a task plan as `understand` returns it.
    terrain: a `Terrain`, or a name or file as for `load_terrain`; places with names can be destinations.
    options: as for ``gaitwright do --set``, without those of the playback.

Returns:
    The plan, and notes on everything that was added or chosen beyond the words.)");
}

}  // namespace gaitwright::python
