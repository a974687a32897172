// SPDX-License-Identifier: BSD-3-Clause
#include "python/bindings/playback.h"

#include <fmt/format.h>
#include <pybind11/eigen.h>
#include <pybind11/functional.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "kinematics/base/file.h"
#include "playback/log/log_json.h"
#include "playback/report/report_page.h"
#include "playback/score/report_text.h"
#include "playback/viewer/viewer_page.h"
#include "python/bindings/bindings.h"
#include "python/bindings/controllers.h"
#include "python/bindings/errors.h"
#include "python/bindings/options.h"
#include "workflows/exchange/export_motion.h"
#include "workflows/study/trial.h"
#include "workflows/walk/walk_report.h"

namespace gaitwright::python {
namespace {

namespace fs = std::filesystem;
namespace py = pybind11;

/// Forwards all calls to a controller with another owner.
class Borrowed : public Controller {
 public:
  explicit Borrowed(Controller& lender) : lender_(lender) {}
  JointCommand Update(const ControlInput& input) override { return lender_.Update(input); }
  void Reset() override { lender_.Reset(); }
  const BaseEstimate* Estimate() const override { return lender_.Estimate(); }
  std::string Name() const override { return lender_.Name(); }

 private:
  Controller& lender_;
};

/// A push as (fx, fy, fz, at_s, for_s).
using PushTuple = std::tuple<double, double, double, double, double>;
using PhaseCallback = std::function<void(const std::string&, double, bool)>;

PlayRequest RequestOf(const std::optional<PushTuple>& push, const PhaseCallback& on_phase, const py::dict& options) {
  PlayRequest request = PlayRequestOf(options);
  if (push) {
    request.play.push_force_W = Vector3(std::get<0>(*push), std::get<1>(*push), std::get<2>(*push));
    request.play.push_at_s = std::get<3>(*push);
    request.play.push_for_s = std::get<4>(*push);
  }
  if (on_phase)
    request.play.on_phase = [on_phase](const GateRecord& phase) { on_phase(phase.phase, phase.at_s, phase.met); };
  return request;
}

Playback Play(const std::shared_ptr<Plan>& plan, const py::object& controller, const std::optional<PushTuple>& push,
              const PhaseCallback& on_phase, const py::dict& options, const std::optional<std::string>& engine) {
  PlayRequest request = RequestOf(push, on_phase, options);
  if (engine) request.play.world.engine = *engine;
  Controller* own = nullptr;
  std::optional<InUse::Turn> turn;
  if (py::isinstance<py::str>(controller)) {
    request.controller = controller.cast<std::string>();
  } else if (py::isinstance<Controller>(controller)) {
    own = controller.cast<Controller*>();
    if (py::isinstance<OwnController>(controller))
      turn.emplace(controller.cast<OwnController&>().played(), "this controller");
  } else {
    throw py::type_error(fmt::format("controller is {}; a Controller, or the name of one, is needed",
                                     py::repr(controller).cast<std::string>()));
  }
  const py::gil_scoped_release others_go_on;
  return {plan,
          Value(own == nullptr ? PlayWalk(plan->model(), plan->motion(), request)
                               : PlayWalk(plan->model(), plan->motion(), request, std::make_unique<Borrowed>(*own)))};
}

const Playback& In(const py::object& self) { return self.cast<const Playback&>(); }

/// A table of log samples, shared with Python.
template <VectorX LogSample::*Column>
py::array LogTable(const py::object& self, const char* name) {
  const std::vector<LogSample>& samples = In(self).log().samples;
  return In(self).tables().Get(self, name, [&] {
    RowMatrix table(static_cast<Eigen::Index>(samples.size()), samples.empty() ? 0 : (samples[0].*Column).size());
    for (Eigen::Index k = 0; k < table.rows(); ++k)
      table.row(k) = (samples[static_cast<std::size_t>(k)].*Column).transpose();
    return table;
  });
}

py::array TimeOf(const py::object& self) {
  const std::vector<LogSample>& samples = In(self).log().samples;
  return In(self).tables().GetColumn(self, "time_s", [&] {
    RowMatrix times(static_cast<Eigen::Index>(samples.size()), 1);
    for (Eigen::Index k = 0; k < times.rows(); ++k) times(k, 0) = samples[static_cast<std::size_t>(k)].time_s;
    return times;
  });
}

py::array ForcesOf(const py::object& self) {
  const std::vector<LogSample>& samples = In(self).log().samples;
  return ForceTable(
      In(self).tables(), self, samples.size(), [&](std::size_t row) -> const auto& { return samples[row].wrenches; });
}

py::dict MetricsOf(const Playback& playback) {
  py::dict metrics;
  for (const Metric& metric : playback.report().metrics) metrics[metric.key.c_str()] = py::cast(metric);
  return metrics;
}

ShownMotion Shown(const Playback& playback) {
  return {TitleOf(playback.plan().model(), playback.plan().motion()), playback.plan().model(), playback.plan().motion(),
          &playback.log(), &playback.report()};
}

std::string ReportHtml(const Playback& playback) {
  const Plan& plan = playback.plan();
  const AuditReport audit = Value(Audit(plan.model(), plan.motion(), {}));
  return WalkReport({plan.model(), plan.motion(), playback.played(), audit});
}

std::vector<std::string> Export(const Playback& playback, const fs::path& path, const std::string& format,
                                double rate_hz) {
  const Plan& plan = playback.plan();
  const ExportedMotion exported =
      ExportLog(plan.model(), playback.log(), &plan.motion(), ExportFormatOf(format), rate_hz, path.string());
  if (const auto written = WriteFilesTogether(exported.files); !written) throw FailureError(written.failure());
  return exported.notes;
}

/// Repeats one trial as `Trials` played it.
Playback PlayOneTrial(const std::shared_ptr<Plan>& plan, std::uint64_t seed, const py::object& disturbances,
                      const std::string& controller, const py::dict& options) {
  PlayRequest request = PlayRequestOf(options);
  request.controller = controller;
  const Disturbances drawn = DisturbancesOf(disturbances, plan->model(), request);
  const py::gil_scoped_release others_go_on;
  return {plan, Value(PlayTrial({plan->model(), plan->motion(), request, drawn}, 0, seed)).played};
}

/// A log with its plan. @throws FailureError if the log is of another plan.
Playback WithPlan(Result<PlaybackLog> log, const std::string& name, const std::shared_ptr<const Plan>& plan) {
  PlayedWalk played;
  played.log = Value(std::move(log));
  if (const std::string hash = MotionHash(plan->motion()); hash != played.log.plan_hash) {
    throw FailureError({FailureKind::kBadInput,
                        FailureCode::kOtherPlan,
                        "LoadLog",
                        fmt::format("'{}' was played from another plan: its motion has hash {}, the log says {}", name,
                                    hash, played.log.plan_hash),
                        {"name the plan that was played"}});
  }
  played.report = Score(plan->model(), plan->motion(), played.log);
  return {plan, std::move(played)};
}

/// None if only one engine has played.
py::object SecondOf(const Playback& playback) {
  const SecondPlayback* second = playback.played().second.get();
  if (second == nullptr) return py::none();
  return py::cast(Playback(playback.shared_plan(), PlayedWalk{*second}));
}

py::object AgreementOfBoth(const Playback& playback) {
  const SecondPlayback* second = playback.played().second.get();
  if (second == nullptr) return py::none();
  return py::module_::import("json").attr("loads")(AgreementJson(second->agreement));
}

py::tuple Pickled(const Playback& playback) {
  return py::make_tuple(std::const_pointer_cast<Plan>(playback.shared_plan()), LogToJson(playback.log()));
}

Playback FromPickle(const py::tuple& parts) {
  return WithPlan(LogFromJson(parts[1].cast<std::string>(), "the pickle"), "the pickle",
                  parts[0].cast<std::shared_ptr<Plan>>());
}

void BindMetric(py::module_& module) {
  py::class_<Metric>(module, "Metric", "A metric of a playback, with its gate.")
      .def_readonly("key", &Metric::key)
      .def_readonly("unit", &Metric::unit)
      .def_readonly("value", &Metric::value, "Measured value; None if it does not exist for this motion.")
      .def_readonly("planned", &Metric::planned, "Value of the plan, computed by the same code as the measured one.")
      .def_readonly("limit", &Metric::limit, "Limit of the gate, if there is one.")
      .def_readonly("applied", &Metric::applied, "Whether the gate counts.")
      .def_readonly("passed", &Metric::pass)
      .def_readonly("not_applied", &Metric::not_applied, "Why a value or a gate is missing.")
      .def_readonly("at_s", &Metric::at_s, "Time of the worst value [s].")
      .def("__repr__", [](const Metric& m) {
        const std::string value = m.value ? FigureText(m, *m.value) : "none";
        return fmt::format("<gaitwright.Metric {}: {}, limit {}>", m.key, value, LimitText(m));
      });
}

}  // namespace

const MotionSeries& Playback::series() const {
  if (!series_)
    series_ = std::make_shared<const MotionSeries>(
        MakeMotionSeries(plan().model(), plan().motion(), log(), ScoreOptionsOf(log())));
  return *series_;
}

void BindPlayback(py::module_& module) {
  BindMetric(module);
  py::class_<Playback> playback(module, "Playback",
                                R"(Measurements of a playback of a plan, and their score.

A playback never changes. Its arrays are shared and read-only.)");
  BindBalance(playback);
  playback
      .def_property_readonly("plan", [](const Playback& p) { return std::const_pointer_cast<Plan>(p.shared_plan()); })
      .def_property_readonly("time_s", TimeOf, "Times of the samples, N [s].")
      .def_property_readonly(
          "q", [](const py::object& self) { return LogTable<&LogSample::q>(self, "q"); },
          "Measured positions q, N x nq.")
      .def_property_readonly(
          "v", [](const py::object& self) { return LogTable<&LogSample::v>(self, "v"); },
          "Measured velocities v, N x nv.")
      .def_property_readonly(
          "tau", [](const py::object& self) { return LogTable<&LogSample::tau>(self, "tau"); },
          "Joint torques, averaged over the interval before each sample, N x n [N m].")
      .def_property_readonly("forces_n", ForcesOf, "Ground forces on the feet, N x feet x 3 [N].")
      .def_property_readonly(
          "passed", [](const Playback& p) { return p.played().pass(); },
          "True if it passed in every engine that played it.")
      .def_property_readonly(
          "engine", [](const Playback& p) { return EngineOf(p.log()); }, "Physics engine of these samples.")
      .def_property_readonly("second", SecondOf,
                             "With engine=\"both\": the playback in the other engine; otherwise None.")
      .def_property_readonly(
          "agreement", AgreementOfBoth,
          "With engine=\"both\": how the engines differ, as in ``walk --json``: first, quantities; otherwise None.")
      .def_property_readonly(
          "score", [](const Playback& p) { return p.report().score; }, "Score, 0 to 100.")
      .def_property_readonly(
          "reason", [](const Playback& p) { return p.played().decisive().report.reason; },
          "Why it fell or failed, or which gate is nearest to its limit; with two engines, of the worse one.")
      .def_property_readonly("metrics", MetricsOf, "Metrics by key.")
      .def_property_readonly("controller", [](const Playback& p) { return p.log().controller; })
      .def_property_readonly(
          "realtime_factor", [](const Playback& p) { return p.played().realtime_factor; },
          "Simulated time divided by CPU time; 0 for a log that was read from a file.")
      .def(
          "to_json", [](const Playback& p) { return LogToJson(p.log()); }, "The log as JSON text.")
      .def(
          "save", [](const Playback& p, const fs::path& path) { return Value(SaveLog(p.log(), path.string())); },
          py::arg("path"), "Writes the log as JSON, as the program does; returns the path.")
      .def("export", Export, py::arg("path"), py::arg("format") = "csv", py::arg("rate_hz") = 0.0,
           "Writes the measured motion as csv, joint-trajectory-yaml, joint-trajectory-json, npz, svg or mjcf; returns "
           "notes on the result.")
      .def("report_html", ReportHtml, "The report as a self-contained HTML page.")
      .def(
          "viewer_html", [](const Playback& p) { return ViewerPage(Shown(p).title, {Shown(p)}); },
          "Self-contained HTML page that shows the motion in 3D.")
      .def(py::pickle(&Pickled, &FromPickle))
      .def("__str__",
           [](const Playback& p) {
             const SecondPlayback* second = p.played().second.get();
             return second == nullptr ? ReportText(p.report())
                                      : ReportText(p.report(), second->report, second->agreement);
           })
      .def("__repr__", [](const Playback& p) {
        return fmt::format("<gaitwright.Playback {}: {}, score {:.1f}>", p.log().robot,
                           p.played().pass() ? "pass" : "fail", p.played().score());
      });
  module.def("play", Play, py::arg("plan").none(false), py::arg("controller") = "stabilised",
             py::arg("push") = py::none(), py::arg("on_phase") = nullptr, py::arg("options") = py::dict(),
             py::arg("engine") = py::none(),
             R"(Plays a plan in physics and scores it.

Args:
    controller: one of CONTROLLERS, or a `Controller` of your own.
    push: (fx, fy, fz, at_s, for_s) on the base, in N and s.
    on_phase: called as on_phase(phase, at_s, met) at the end of each phase, for plans that have phases.
    options: as for ``gaitwright play --set``, such as ``{"play.friction": 0.6, "state": "estimated"}``, and
        ``"sensors"``: "ideal", "good" or "hobby", as for ``--sensors``.
    engine: "bullet", "mujoco" or "both" (passes if both pass); default: that of the options, otherwise "bullet".)");
  module.def(
      "play_trial", PlayOneTrial, py::arg("plan").none(false), py::arg("seed"), py::kw_only(),
      py::arg("disturbances") = "standard", py::arg("controller") = "stabilised", py::arg("options") = py::dict(),
      "Repeats one trial of `trials` by its seed (`TrialsReport.seeds`, `worst_seeds`) with the same arguments.");
  module.def(
      "load_log",
      [](const fs::path& path, const std::shared_ptr<Plan>& plan) {
        return WithPlan(LoadLog(path.string()), path.string(), plan);
      },
      py::arg("path"), py::arg("plan").none(false),
      "Reads a log from a file, with its plan; any other plan is refused.");
}

}  // namespace gaitwright::python
