// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <pybind11/eigen.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <memory>
#include <string>
#include <utility>

#include "python/bindings/bindings.h"
#include "python/bindings/errors.h"
#include "python/bindings/options.h"
#include "python/bindings/plan.h"
#include "python/bindings/playback.h"
#include "python/bindings/terrain.h"
#include "workflows/exchange/frame_motion_internal.h"
#include "workflows/exchange/motion_rows.h"
#include "workflows/exchange/npz_motion_internal.h"
#include "workflows/repair/played_repair_internal.h"

namespace gaitwright::python {
namespace {

namespace fs = std::filesystem;
namespace py = pybind11;

/// A repaired motion. It never changes.
class Repair {
 public:
  Repair(const SharedRobot& robot, PlayedRepair done)
      : plan_(std::make_shared<Plan>(robot, std::move(done.repaired.plan))),
        done_(std::make_shared<const PlayedRepair>(std::move(done))) {}

  const std::shared_ptr<Plan>& plan() const { return plan_; }
  const PlayedRepair& done() const { return *done_; }
  RepairResult result() const { return done_->ResultOf(plan_->model()); }

 private:
  std::shared_ptr<Plan> plan_;
  std::shared_ptr<const PlayedRepair> done_;
};

/// A motion given as arrays by name: NumPy packs them, and the reader of its files reads them.
MotionTable TableOf(const SharedRobot& robot, const py::dict& arrays, const ImportOptions& options) {
  const py::object buffer = py::module_::import("io").attr("BytesIO")();
  py::module_::import("numpy").attr("savez")(buffer, **arrays);
  const std::string bytes = py::cast<py::bytes>(buffer.attr("getvalue")());
  return Value(ParseNpzMotion(*robot, bytes, "the arrays", options));
}

RepairRequest RequestOf(const SharedRobot& robot, const py::object& motion, const py::object& terrain,
                        const py::dict& options) {
  RepairRequest request;
  SetOptions(request.Fields(), options);
  request.ground = TerrainOf(terrain, *robot);
  request.source.terrain = request.ground->name;
  if (py::isinstance<py::dict>(motion)) {
    request.source.file = "the arrays";
    request.table = TableOf(robot, motion, request.source.options);
  } else {
    request.source.file = py::cast<fs::path>(motion).string();
  }
  return request;
}

/// @param weights  None, a file, or a dictionary as in a file.
void SetWeightsOf(const py::object& weights, RepairRequest& request) {
  if (weights.is_none()) return;
  if (py::isinstance<py::dict>(weights)) {
    request.weights_file = "the weights";
    request.weights_text = py::cast<std::string>(py::module_::import("json").attr("dumps")(weights));
  } else {
    request.weights_file = py::cast<fs::path>(weights).string();
  }
}

std::shared_ptr<Repair> RepairGiven(const SharedRobot& robot, const py::object& motion, const py::object& terrain,
                                    const py::object& weights, bool play, const py::dict& options) {
  RepairRequest request = RequestOf(robot, motion, terrain, options);
  SetWeightsOf(weights, request);
  const py::gil_scoped_release others_go_on;
  return std::make_shared<Repair>(robot, Value(RepairAndPlay(*robot, request, play)));
}

/// The repaired motion as the arrays in which motions are given.
py::dict FramesOf(const Repair& repair, double rate_hz) {
  const RobotModel& model = repair.plan()->model();
  const MotionRows rows = RowsOfPlan(model, repair.plan()->motion(), rate_hz);
  const std::vector<std::string> order = DescribedJointOrder(model);
  RowMatrix joints(rows.size(), static_cast<Eigen::Index>(order.size()));
  const RowMatrix q = Rows(rows.q);
  for (Eigen::Index i = 0; i < joints.cols(); ++i)
    joints.col(i) = q.col(7 + model.DofIndex(order[static_cast<std::size_t>(i)]));
  py::dict frames;
  frames["fps"] = rate_hz;
  frames["root_pos"] = RowMatrix(q.leftCols<3>());
  frames["root_rot"] = RowMatrix(q.middleCols<4>(3));
  frames["dof_pos"] = joints;
  frames["joint_names"] = order;
  return frames;
}

py::object DistanceOfRepair(const Repair& repair) {
  return py::module_::import("json").attr("loads")(RepairJson(repair.result()))["distance"];
}

std::vector<std::string> ChangeTexts(const Repair& repair) {
  std::vector<std::string> texts;
  if (repair.done().repaired.findings.kept) return texts;
  for (const RepairChange& change : ChangesOf(repair.plan()->model(), repair.done().repaired.findings))
    texts.push_back(change.text);
  return texts;
}

}  // namespace

void BindRepair(py::module_& module) {
  py::class_<Repair, std::shared_ptr<Repair>>(module, "Repair", "The nearest motion that a robot can do.")
      .def_property_readonly(
          "passed", [](const Repair& r) { return r.result().pass(); },
          "Whether the plan passes its audit and all engines that played it.")
      .def_property_readonly(
          "kept", [](const Repair& r) { return r.done().repaired.findings.kept; },
          "Whether the motion was sound as it was, and was kept.")
      .def_property_readonly("plan", &Repair::plan)
      .def_property_readonly(
          "before", [](const Repair& r) { return r.done().repaired.findings.before; },
          "Audit of the motion as it was given; None if it could not be audited.")
      .def_property_readonly(
          "audit", [](const Repair& r) { return r.done().repaired.after; }, "Audit of the plan.")
      .def_property_readonly("distance", DistanceOfRepair,
                             "Distance of the plan from the motion as it was given, as `distance` in the JSON of "
                             "`gaitwright repair` (docs/repair.md); `groups` has it by part of the robot.")
      .def_property_readonly("changes", ChangeTexts, "What was changed, each in a sentence.")
      .def("frames", FramesOf, py::arg("rate_hz") = 30.0,
           "The motion as arrays in a dictionary, such as `repair` takes: fps, root_pos, root_rot (x y z w), dof_pos, "
           "joint_names.")
      .def("to_json", [](const Repair& r) { return RepairJson(r.result()); })
      .def("__str__", [](const Repair& r) { return RepairText(r.result()); })
      .def("__bool__", [](const Repair& r) { return r.result().pass(); });
  module.def("repair", RepairGiven, py::arg("robot").none(false), py::arg("motion").none(false), py::kw_only(),
             py::arg("terrain") = "flat", py::arg("weights") = py::none(), py::arg("play") = true,
             py::arg("options") = py::dict(), "As `gaitwright.repair`, which sets `repair.stretch` among the options.");
}

}  // namespace gaitwright::python
