// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <pybind11/eigen.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <memory>
#include <optional>
#include <tuple>

#include "python/bindings/bindings.h"
#include "python/bindings/errors.h"
#include "python/bindings/options.h"
#include "python/bindings/plan.h"
#include "python/bindings/terrain.h"
#include "workflows/exchange/import_motion.h"
#include "workflows/exchange/placed_steps.h"
#include "workflows/walk/walk.h"
#include "workflows/walk/walk_extent.h"

namespace gaitwright::python {
namespace {

namespace fs = std::filesystem;
namespace py = pybind11;

using PoseTuple = std::tuple<double, double, double>;
using SharedPlan = std::shared_ptr<Plan>;

/// The request for a walk, without robot and ground.
struct Asked {
  double speed_m_s, lateral_speed_m_s, yaw_rate_rad_s;
  WalkExtent extent;
};

SharedPlan PlanAsked(const SharedRobot& robot, const Asked& asked, const Terrain& terrain, WalkRequest request) {
  request.command.speed_m_s = asked.speed_m_s;
  request.command.lateral_speed_m_s = asked.lateral_speed_m_s;
  request.command.yaw_rate_rad_s = asked.yaw_rate_rad_s;
  SetExtent(*robot, asked.extent, request.command);
  const py::gil_scoped_release others_go_on;
  return std::make_shared<Plan>(robot, Value(PlanWalkOn(*robot, terrain, request)).motion.plan);
}

SharedPlan PlanAWalk(const SharedRobot& robot, const std::string& gait, const py::object& terrain, double speed,
                     double lateral_speed, double yaw_rate, const std::optional<double>& distance,
                     const std::optional<double>& duration, const std::optional<PoseTuple>& goal,
                     const std::optional<int>& steps, const std::optional<double>& step_length,
                     const std::string& sequence, std::uint64_t seed, const py::dict& options) {
  if (!sequence.empty() && (!gait.empty() || speed != 0.0 || lateral_speed != 0.0 || yaw_rate != 0.0 || distance ||
                            duration || goal || steps || step_length))
    throw InvalidArgument("a sequence sets gaits, speeds and distances: leave out the other arguments that set them");
  WalkRequest request;
  request.gait = gait;
  request.sequence = sequence;
  request.seed = seed;
  SetOptions(request.Fields(), options);
  const Terrain ground = TerrainOf(terrain, *robot);
  request.terrain = ground.name;
  Asked asked{speed, lateral_speed, yaw_rate, {distance, duration, {}, steps, step_length}};
  if (goal) asked.extent.goal = PlanarPose{std::get<0>(*goal), std::get<1>(*goal), std::get<2>(*goal)};
  return PlanAsked(robot, asked, ground, std::move(request));
}

using StepTuple = std::tuple<std::string, double, double, double>;

SharedPlan PlanSteps(const SharedRobot& robot, const std::vector<StepTuple>& steps, const py::object& terrain,
                     double swing_s, double pause_s, const py::dict& options) {
  MotionOptions motion;
  SetOptions(motion.Fields(), options);
  const Terrain ground = TerrainOf(terrain, *robot);
  std::vector<PlacedStep> placed;
  for (const auto& [foot, x_m, y_m, yaw_rad] : steps) placed.push_back({FootIndex(*robot, foot), {x_m, y_m, yaw_rad}});
  const py::gil_scoped_release others_go_on;
  return std::make_shared<Plan>(robot, Value(PlanOverSteps(*robot, ground, placed, {swing_s, pause_s}, motion)));
}

SharedPlan Import(const SharedRobot& robot, const fs::path& path, const py::object& terrain, const fs::path& columns,
                  const py::dict& options) {
  ImportRequest request;
  request.file = path.string();
  request.columns_file = columns.string();
  SetOptions(request.Fields(), options);
  const Terrain ground = TerrainOf(terrain, *robot);
  request.terrain = ground.name;
  const py::gil_scoped_release others_go_on;
  return std::make_shared<Plan>(robot, Value(ImportMotionOn(*robot, ground, request)).plan);
}

}  // namespace

void BindPlanning(py::module_& module) {
  module.def("plan_walk", PlanAWalk, py::arg("robot").none(false), py::kw_only(), py::arg("gait") = "",
             py::arg("terrain") = "flat", py::arg("speed") = 0.0, py::arg("lateral_speed") = 0.0,
             py::arg("yaw_rate") = 0.0, py::arg("distance") = py::none(), py::arg("duration") = py::none(),
             py::arg("goal") = py::none(), py::arg("steps") = py::none(), py::arg("step_length") = py::none(),
             py::arg("sequence") = "", py::arg("seed") = 0, py::arg("options") = py::dict(),
             R"(Plans a walk and audits it; a plan that fails its audit is not returned.

Args:
    gait: name of a gait, or a file of gaits; "" for the robot's best gait.
    terrain: a `Terrain`, or a name or file as for `load_terrain`.
    speed, lateral_speed, yaw_rate: speed forward and to the left [m/s], yaw rate to the left [rad/s]; if none is given,
        the robot's default speed.
    distance, duration, goal, steps: extent of the walk, at most one of them: [m], [s], (x, y, yaw), number of steps;
        default: 1 m.
    step_length: advance per footfall [m]; with steps, instead of speed.
    sequence: parts in sequence, instead of all of the above, such as "trot: speed=0.5, distance=1; stand: duration=1".
    options: as for ``gaitwright plan --set``, such as ``{"swing.height_m": 0.06}``.

Raises:
    BadInputError: an argument is wrong.
    InfeasibleError: no plan exists within the limits; the message names the constraint and the excess.)");
  module.def("plan_footsteps", PlanSteps, py::arg("robot").none(false), py::arg("steps"), py::kw_only(),
             py::arg("terrain") = "flat", py::arg("swing_s") = 0.5, py::arg("pause_s") = 0.1,
             py::arg("options") = py::dict(),
             R"(Plans a motion over given footsteps, such as those of your own planner.

Args:
    steps: (foot, x, y, yaw) each, in order; the robot first stands at the origin and faces x. x and y are the middle of
        the sole, or the contact point [m]; yaw is relative to the standing posture [rad].
    swing_s, pause_s: time of a step, and time on all feet after it [s].

The plan is not audited, so that you can also examine a plan that violates constraints: call `audit`. Its ``warnings``
name the limits that it exceeds.)");
  module.def("import_motion", Import, py::arg("robot").none(false), py::arg("path"), py::kw_only(),
             py::arg("terrain") = "flat", py::arg("columns") = "", py::arg("options") = py::dict(),
             "Makes a plan from a motion of other software: CSV, ROS joint trajectory or footsteps (docs/import.md).");
}

}  // namespace gaitwright::python
