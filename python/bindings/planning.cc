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

/// What is asked of a walk beside robot and ground.
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
    throw InvalidArgument("a sequence names its own gaits, speeds and ways: leave the other ones out");
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
             R"(Plans a walk and audits it; what fails its audit is not handed out.

Args:
    gait: by name, or a file of gaits; "" for the robot's best.
    terrain: a `Terrain`, or a name or a file as of `load_terrain`.
    speed, lateral_speed, yaw_rate: ahead and to the left [m/s], turning to the left [rad/s]; without any of these the
        robot's own speed.
    distance, duration, goal, steps: how far, one of them [m], [s], (x, y, yaw), footfalls; 1 m where none is given.
    step_length: advance in a footfall [m], with steps and instead of speed.
    sequence: parts one after the other instead of all these, as "trot: speed=0.5, distance=1; stand: duration=1".
    options: as of ``gaitwright plan --set``, such as ``{"swing.height_m": 0.06}``.

Raises:
    BadInputError: an argument is wrong.
    InfeasibleError: no plan exists within the limits: what forbids it, and by how much.)");
  module.def("plan_footsteps", PlanSteps, py::arg("robot").none(false), py::arg("steps"), py::kw_only(),
             py::arg("terrain") = "flat", py::arg("swing_s") = 0.5, py::arg("pause_s") = 0.1,
             py::arg("options") = py::dict(),
             R"(Plans a motion over footsteps of your own planner.

Args:
    steps: (foot, x, y, yaw) each, one after the other; the robot stands at the origin first and faces x. The place is
        that of the sole's middle, or of the contact point [m]; yaw is beyond that of standing [rad].
    swing_s, pause_s: time of a step, and on all feet after it [s].

What it gives is not audited, so that a plan which breaks laws can be looked at: ask `audit`. Its ``warnings`` say which
limits it goes beyond.)");
  module.def("import_motion", Import, py::arg("robot").none(false), py::arg("path"), py::kw_only(),
             py::arg("terrain") = "flat", py::arg("columns") = "", py::arg("options") = py::dict(),
             "A plan of a motion that others made: CSV, joint trajectory of ROS, or footsteps (docs/import.md).");
}

}  // namespace gaitwright::python
