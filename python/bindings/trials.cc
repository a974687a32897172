// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <pybind11/eigen.h>
#include <pybind11/functional.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

#include "kinematics/base/nearest_name.h"
#include "playback/report/trials_page.h"
#include "python/bindings/bindings.h"
#include "python/bindings/errors.h"
#include "python/bindings/options.h"
#include "python/bindings/playback.h"
#include "python/bindings/policies.h"
#include "workflows/study/run_trials.h"

namespace gaitwright::python {
namespace {

namespace py = pybind11;

using Progress = std::function<void(int done, int wanted)>;

/// Runs trials, which the caller can interrupt. @param play  with its controller.
RobustnessReport RunHere(const Plan& plan, PlayRequest play, const py::object& disturbances, const TrialOptions& trials,
                         const Progress& progress) {
  const Disturbances drawn = DisturbancesOf(disturbances, plan.model(), play);
  TrialHooks hooks;
  std::atomic<bool> interrupted = false;
  hooks.progress = [&](const TrialProgress& p) {
    const py::gil_scoped_acquire python;
    if (progress) progress(p.done, p.wanted);
  };
  hooks.stop = [&] {
    const py::gil_scoped_acquire python;
    if (PyErr_CheckSignals() != 0) interrupted = true;
    return interrupted.load();
  };
  Result<RobustnessReport> report = [&] {
    const py::gil_scoped_release others_go_on;
    return RunTrials({plan.model(), plan.motion(), play, drawn}, trials, hooks);
  }();
  if (interrupted) throw py::error_already_set();
  return Value(std::move(report));
}

/// @param motion  a Plan, which the controller follows, or a Policy.
RobustnessReport Trials(const py::object& motion, int n, const py::object& disturbances,
                        const std::optional<std::string>& controller, int seed, int threads, const Progress& progress,
                        const py::dict& options) {
  PlayRequest play = PlayRequestOf(options);
  const TrialOptions trials{.trials = n, .seed = seed, .threads = threads};
  if (!py::isinstance<Policy>(motion)) {
    if (controller) play.controller = *controller;
    return RunHere(*py::cast<std::shared_ptr<Plan>>(motion), std::move(play), disturbances, trials, progress);
  }
  if (controller) throw InvalidArgument("a policy is its own controller");
  const auto policy = py::cast<std::shared_ptr<Policy>>(motion);
  UsePolicy(policy->prepared(), play);
  return RunHere(*policy->plan(), std::move(play), disturbances, trials, progress);
}

/// Values of a trial by name, measured or sampled.
std::vector<std::pair<std::string, std::optional<double>>> FiguresOf(const TrialOutcome& outcome) {
  std::vector<std::pair<std::string, std::optional<double>>> figures(outcome.metrics.begin(), outcome.metrics.end());
  for (const SampledValue& value : outcome.sampled) figures.emplace_back(value.name, value.value);
  return figures;
}

/// Names of all values, in the order of their first appearance.
std::vector<std::string> ColumnsOf(const RobustnessReport& report) {
  std::vector<std::string> names;
  for (const TrialOutcome& outcome : report.outcomes)
    for (const auto& [name, value] : FiguresOf(outcome))
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  return names;
}

/// One value per trial; NaN if the trial does not have it.
VectorX Column(const RobustnessReport& report, const std::string& key) {
  VectorX column = VectorX::Constant(static_cast<Eigen::Index>(report.outcomes.size()), std::nan(""));
  bool known = false;
  for (Eigen::Index k = 0; k < column.size(); ++k) {
    for (const auto& [name, value] : FiguresOf(report.outcomes[static_cast<std::size_t>(k)])) {
      if (name != key) continue;
      known = true;
      if (value) column[k] = *value;
    }
  }
  if (!known)
    throw InvalidArgument(
        fmt::format("the trials have no value '{}', measured or sampled{}", key, NearestHint(key, ColumnsOf(report))));
  return column;
}

template <class Number, Number TrialOutcome::*Field>
std::vector<Number> Each(const RobustnessReport& report) {
  std::vector<Number> all;
  for (const TrialOutcome& outcome : report.outcomes) all.push_back(outcome.*Field);
  return all;
}

py::dict CausesOf(const RobustnessReport& report) {
  py::dict causes;
  for (const Tally& cause : report.causes) causes[cause.what.c_str()] = cause.count;
  return causes;
}

std::vector<std::uint64_t> WorstOf(const RobustnessReport& report) {
  std::vector<std::uint64_t> seeds;
  for (const int number : report.worst) seeds.push_back(report.Outcome(number).seed);
  return seeds;
}

bool IsFile(const std::string& path) {
  std::error_code unknown;
  return std::filesystem::exists(path, unknown);
}

}  // namespace

Disturbances DisturbancesOf(const py::object& which, const RobotModel& model, PlayRequest& request) {
  const OptionFields sensors = SensorFields(request);
  const auto read = [&]() -> Result<Disturbances> {
    if (py::isinstance<py::dict>(which)) {
      const py::object json = py::module_::import("json").attr("dumps")(which);
      return ReadDisturbances(json.cast<std::string>(), sensors, "the disturbances");
    }
    const std::string text = py::module_::import("os").attr("fspath")(which).cast<std::string>();
    const bool is_text = text.find('\n') != std::string::npos || (text.find(':') != std::string::npos && !IsFile(text));
    return is_text ? ReadDisturbances(text, sensors, "the disturbances") : LoadDisturbances(text, sensors);
  };
  if (py::isinstance<py::str>(which) && which.cast<std::string>() == "standard") return StandardBesides(model, request);
  Disturbances disturbances = Value(read());
  if (const auto failure = ReasonNotSampled(model, request, disturbances)) throw FailureError(*failure);
  return disturbances;
}

void BindTrials(py::module_& module) {
  py::class_<RobustnessReport>(module, "TrialsReport", "Result of many playbacks under disturbances.")
      .def_readonly("n", &RobustnessReport::n)
      .def_readonly("survived", &RobustnessReport::survived, "Trials that did not fall and reached the end.")
      .def_readonly("passed", &RobustnessReport::passed, "Trials that also passed all gates.")
      .def_property_readonly("survival", [](const RobustnessReport& r) { return r.survival.share; })
      .def_property_readonly(
          "survival_interval",
          [](const RobustnessReport& r) { return py::make_tuple(r.survival.low, r.survival.high); },
          "Confidence interval of the survival rate at 95 % (Wilson).")
      .def_property_readonly("causes", CausesOf, "Causes of falls, and the number of falls of each.")
      .def_property_readonly("scores", Each<double, &TrialOutcome::score>, "Of each trial.")
      .def_property_readonly("seeds", Each<std::uint64_t, &TrialOutcome::seed>, "Of each trial.")
      .def_property_readonly("worst_seeds", WorstOf,
                             "Seeds of the worst trials, worst first; `play_trial` repeats one.")
      .def_property_readonly("columns", ColumnsOf, "Names that `column` accepts.")
      .def("column", Column, py::arg("key"),
           "Values of a metric or a sampled quantity for all trials, such as ``\"zmp_margin_min_m\"`` or "
           "``\"friction\"``.")
      .def("to_json", RobustnessJson)
      .def("report_html", TrialsPage, "The report as a self-contained HTML page.")
      .def("__str__", RobustnessText)
      .def("__repr__", [](const RobustnessReport& r) {
        return fmt::format("<gaitwright.TrialsReport: {} of {} survived, {:.1f} to {:.1f} %>", r.survived, r.n,
                           100.0 * r.survival.low, 100.0 * r.survival.high);
      });
  module.def("trials", Trials, py::arg("motion").none(false), py::arg("n") = 100, py::kw_only(),
             py::arg("disturbances") = "standard", py::arg("controller") = py::none(), py::arg("seed") = 0,
             py::arg("threads") = 0, py::arg("progress") = nullptr, py::arg("options") = py::dict(),
             R"(Plays a plan or policy many times under sampled disturbances and measures the survival rate.

Args:
    motion: a `Plan` or a `Policy`. A policy that is a callable is called from several trials in turn: it must not keep
        a state from call to call, or ``threads`` must be 1.
    n: number of trials.
    controller: of a plan; default "stabilised".
    disturbances: "standard", the path of a YAML file, its text, or a dictionary with its content (docs/trials.md),
        such as ``{"friction": 0.5}``.
    threads: number of threads, which does not change the result; 0: one per core.
    progress: called as progress(done, wanted) after each trial.
    options: options of the playback, as for `play`.)");
}

}  // namespace gaitwright::python
