// SPDX-License-Identifier: BSD-3-Clause
#include "python/bindings/plan.h"

#include <fmt/format.h>
#include <pybind11/eigen.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "planning/plan/plan_json.h"
#include "planning/plan/sample_plan.h"
#include "playback/report/report_page.h"
#include "playback/viewer/viewer_page.h"
#include "python/bindings/bindings.h"
#include "python/bindings/errors.h"
#include "workflows/exchange/export_motion.h"
#include "workflows/walk/walk.h"

namespace gaitwright::python {
namespace {

namespace fs = std::filesystem;
namespace py = pybind11;

SharedRobot RobotIn(const MotionPlan& motion) { return std::make_shared<RobotModel>(Value(RobotOf(motion))); }

const Plan& PlanIn(const py::object& self) { return self.cast<const Plan&>(); }

/// Times of a uniform grid.
RowMatrix Times(double start_s, double step_s, int count) {
  RowMatrix times(count, 1);
  for (int k = 0; k < count; ++k) times(k, 0) = start_s + k * step_s;
  return times;
}

/// A table of whole-body rows, shared with Python.
template <std::vector<VectorX> WholeBodyTrajectory::*Column>
py::array BodyTable(const py::object& self, const char* name) {
  const Plan& plan = PlanIn(self);
  return plan.tables().Get(self, name, [&] { return Rows(plan.motion().whole_body.*Column); });
}

py::array TimeOf(const py::object& self) {
  const Plan& plan = PlanIn(self);
  const WholeBodyTrajectory& body = plan.motion().whole_body;
  return plan.tables().GetColumn(self, "time_s", [&] { return Times(body.start_s, body.step_s, body.size()); });
}

py::array ForcesOf(const py::object& self) {
  const auto& wrenches = PlanIn(self).motion().whole_body.wrenches;
  return ForceTable(
      PlanIn(self).tables(), self, wrenches.size(), [&](std::size_t row) -> const auto& { return wrenches[row]; });
}

/// Tables of the centre of mass and the ZMP, on the centroidal time grid.
struct CentroidalTables {
  static py::array Time(const py::object& self) {
    const CentroidalTrajectory& c = PlanIn(self).motion().centroidal;
    return PlanIn(self).tables().GetColumn(self, "centroidal.time_s",
                                           [&] { return Times(c.start_s, c.step_s, c.size()); });
  }
  template <class Vector, std::vector<Vector> CentroidalTrajectory::*Column>
  static py::array Of(const py::object& self, const char* name) {
    const CentroidalTrajectory& c = PlanIn(self).motion().centroidal;
    return PlanIn(self).tables().Get(self, name, [&] { return Rows(c.*Column); });
  }
};

py::list FootholdsOf(const Plan& plan) {
  py::list list;
  for (const Foothold& foothold : plan.motion().footsteps.footholds) {
    py::dict one;
    one["foot"] = plan.model().feet[static_cast<std::size_t>(foothold.foot)].name;
    one["pose"] = py::cast(Eigen::Matrix4d(foothold.X_WF.matrix()));
    one["touchdown_s"] = foothold.touchdown_s;
    one["liftoff_s"] = foothold.liftoff_s;
    if (foothold.heel_off_s) one["heel_off_s"] = *foothold.heel_off_s;
    list.append(one);
  }
  return list;
}

py::list AdjustmentsOf(const Plan& plan) {
  py::list list;
  for (const Adjustment& adjustment : plan.motion().adjustments) {
    py::dict one;
    one["what"] = adjustment.what;
    one["asked"] = adjustment.asked;
    one["given"] = adjustment.given;
    one["unit"] = adjustment.unit;
    one["why"] = FailureCodeName(adjustment.why);
    one["part"] = adjustment.part;
    list.append(one);
  }
  return list;
}

/// Whether each foot is scheduled to stand, by row.
py::array ContactOf(const py::object& self) {
  const Plan& plan = PlanIn(self);
  return plan.tables().GetTruths(self, "contact", [&] {
    const WholeBodyTrajectory& body = plan.motion().whole_body;
    const ContactSchedule& schedule = plan.motion().schedule;
    TruthMatrix stands(body.size(), static_cast<Eigen::Index>(plan.model().feet.size()));
    for (int k = 0; k < body.size(); ++k) {
      const int phase = PhaseAt(schedule, body.start_s + k * body.step_s);
      const FootSet stance = schedule.phases.empty() ? 0 : schedule.phases[static_cast<std::size_t>(phase)].stance;
      for (int foot = 0; foot < stands.cols(); ++foot) stands(k, foot) = Contains(stance, foot);
    }
    return stands;
  });
}

py::dict SampleAt(const Plan& plan, double time_s) {
  WholeBodySample sample;
  SampleWholeBody(plan.motion().whole_body, time_s, sample);
  py::dict at;
  at["q"] = py::cast(sample.q);
  at["v"] = py::cast(sample.v);
  at["a"] = py::cast(sample.a);
  at["tau"] = py::cast(sample.tau);
  return at;
}

std::vector<std::string> Export(const Plan& plan, const fs::path& path, const std::string& format, double rate_hz,
                                bool cycle) {
  const ExportPart part = cycle ? ExportPart::kCycle : ExportPart::kAll;
  const ExportedMotion exported =
      ExportPlan(plan.model(), plan.motion(), ExportFormatOf(format), rate_hz, path.string(), part);
  if (const auto written = WriteFilesTogether(exported.files); !written) throw FailureError(written.failure());
  return exported.notes;
}

void BindArrays(py::class_<Plan, std::shared_ptr<Plan>>& plan) {
  using Body = WholeBodyTrajectory;
  using Centre = CentroidalTrajectory;
  plan.def_property_readonly("time_s", TimeOf, "Times of the rows, N [s].")
      .def_property_readonly(
          "q", [](const py::object& self) { return BodyTable<&Body::q>(self, "q"); }, "Positions q, N x nq.")
      .def_property_readonly(
          "v", [](const py::object& self) { return BodyTable<&Body::v>(self, "v"); }, "Velocities v, N x nv.")
      .def_property_readonly(
          "a", [](const py::object& self) { return BodyTable<&Body::a>(self, "a"); }, "Accelerations, N x nv.")
      .def_property_readonly(
          "tau", [](const py::object& self) { return BodyTable<&Body::tau>(self, "tau"); },
          "Feed-forward joint torques, N x n [N m], or forces [N] of prismatic joints.")
      .def_property_readonly("forces_n", ForcesOf, "Ground forces on the feet, N x feet x 3 [N].")
      .def_property_readonly("contact", ContactOf, "Whether each foot is scheduled to stand, N x feet.")
      .def_property_readonly("centroidal_time_s", CentroidalTables::Time,
                             "Times of the rows of centre_of_mass_m and zmp_m, M [s].")
      .def_property_readonly(
          "centre_of_mass_m",
          [](const py::object& self) { return CentroidalTables::Of<Vector3, &Centre::p_WC>(self, "p_WC"); }, "M x 3")
      .def_property_readonly(
          "centre_of_mass_velocity_m_s",
          [](const py::object& self) { return CentroidalTables::Of<Vector3, &Centre::v_WC>(self, "v_WC"); }, "M x 3")
      .def_property_readonly(
          "zmp_m", [](const py::object& self) { return CentroidalTables::Of<Vector2, &Centre::p_WZ>(self, "p_WZ"); },
          "Reference of the zero-moment point, M x 2 [m].");
}

}  // namespace

Plan::Plan(MotionPlan motion)
    : robot_(RobotIn(motion)), motion_(std::make_shared<const MotionPlan>(std::move(motion))) {}

void BindPlan(py::module_& module) {
  py::class_<Plan, std::shared_ptr<Plan>> plan(
      module, "Plan", R"(A motion plan: footholds, contacts, centre of mass, joints and torques.

A plan never changes. Its arrays are shared and read-only: to change an array, copy it.)");
  BindArrays(plan);
  plan.def_property_readonly("robot", &Plan::robot)
      .def_property_readonly("terrain", [](const Plan& p) { return p.motion().terrain; })
      .def_property_readonly("duration_s", [](const Plan& p) { return p.motion().duration_s(); })
      .def_property_readonly(
          "gait", [](const Plan& p) { return GaitNames(p.motion().parts); }, "Names of the gaits of its parts.")
      .def_property_readonly(
          "warnings", [](const Plan& p) { return p.motion().warnings; },
          "Limits that the plan exceeds, as far as the planner knows.")
      .def_property_readonly("adjustments", AdjustmentsOf,
                             "Differences from the request: dictionaries with what, asked, given, unit, why, part.")
      .def_property_readonly("footholds", FootholdsOf,
                             "Footholds as dictionaries with foot, pose (4 x 4), touchdown_s, liftoff_s,"
                             " and heel_off_s for a sole that raises its heel.")
      .def_property_readonly("hash", [](const Plan& p) { return PlanHash(p.motion()); })
      .def(
          "viewer_html",
          [](const Plan& p) {
            const ShownMotion shown{TitleOf(p.model(), p.motion()), p.model(), p.motion(), nullptr, nullptr};
            return ViewerPage(shown.title, {shown});
          },
          "Self-contained HTML page that shows the motion in 3D.")
      .def(py::pickle([](const Plan& p) { return py::str(PlanToJson(p.motion())); },
                      [](const py::str& text) { return Plan(Value(PlanFromJson(text, "the pickle"))); }))
      .def("at", SampleAt, py::arg("time_s"), "q, v, a and tau at any time; interpolates between the rows.")
      .def("to_json", [](const Plan& p) { return PlanToJson(p.motion()); })
      .def_static(
          "from_json", [](const std::string& text) { return Plan(Value(PlanFromJson(text, "the text"))); },
          py::arg("text"))
      .def(
          "save", [](const Plan& p, const fs::path& path) { return Value(SavePlan(p.motion(), path.string())); },
          py::arg("path"), "Writes the plan as JSON, as the program does; returns the path.")
      .def("export", Export, py::arg("path"), py::arg("format") = "csv", py::arg("rate_hz") = 0.0,
           py::arg("cycle") = false,
           "Writes a file in a format of `gaitwright export`, whole or one steady cycle; returns notes on the result.")
      .def("__repr__", [](const Plan& p) {
        return fmt::format("<gaitwright.Plan {}: {}, {:.2f} s, {} footholds>", p.motion().robot,
                           GaitNames(p.motion().parts), p.motion().duration_s(), p.motion().footsteps.footholds.size());
      });
  module.def(
      "load_plan", [](const fs::path& path) { return Plan(Value(LoadPlan(path.string()))); }, py::arg("path"),
      "Reads a plan from a file of the program or of `Plan.save`.");
}

}  // namespace gaitwright::python
