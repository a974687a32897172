// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "python/bindings/bindings.h"
#include "python/bindings/playback.h"
#include "workflows/compare/comparison_text.h"

namespace gaitwright::python {
namespace {

namespace py = pybind11;

/// A comparison of two motions, with the data that its page draws.
struct Comparison {
  ComparedMotion a, b;
  MotionComparison motions;
  std::vector<MetricPair> metrics;
};

/// Reads one side. Sets `played` to the plan that was played, if there is one.
ComparedMotion SideOf(const py::object& side, const std::string& name, const MotionPlan*& played) {
  if (py::isinstance<Plan>(side)) {
    const auto& plan = side.cast<const Plan&>();
    return ComparedPlan(plan.model(), plan.motion(), name);
  }
  if (!py::isinstance<Playback>(side))
    throw py::type_error(
        fmt::format("{} is {}; a Plan or a Playback is needed", name, py::repr(side).cast<std::string>()));
  const auto& playback = side.cast<const Playback&>();
  played = &playback.plan().motion();
  return ComparedLog(playback.plan().model(), playback.log(), name);
}

Comparison Compare(const py::object& a, const py::object& b, const std::string& align, double tolerance) {
  CompareOptions options{align, tolerance};
  CheckOptions(options.Fields());
  const MotionPlan* played = nullptr;
  Comparison comparison{SideOf(a, "a", played), SideOf(b, "b", played), {}, {}};
  const py::gil_scoped_release others_go_on;
  comparison.motions = CompareMotions(comparison.a, comparison.b, options);
  comparison.metrics = MetricsOf(comparison.a, comparison.b, played, tolerance);
  return comparison;
}

py::dict DictOf(const FirstDifference& first) {
  return py::dict(py::arg("quantity") = first.quantity, py::arg("at_s") = first.time_s, py::arg("a") = first.a,
                  py::arg("b") = first.b, py::arg("unit") = first.unit, py::arg("tolerance") = first.tolerance);
}

std::vector<py::dict> DifferencesOf(const Comparison& comparison) {
  std::vector<py::dict> all;
  for (const FirstDifference& first : comparison.motions.in_order) all.push_back(DictOf(first));
  return all;
}

}  // namespace

void BindCompare(py::module_& module) {
  py::class_<Comparison>(module, "Comparison", "A comparison of two motions; differences are b - a.")
      .def_property_readonly(
          "same", [](const Comparison& c) { return c.motions.same(); }, "True if all differences are within tolerance.")
      .def_property_readonly("differences", DifferencesOf,
                             "Differences in order of time, each quantity once: quantity, at_s, a, b, unit, tolerance.")
      .def_property_readonly("notes", [](const Comparison& c) { return c.motions.notes; })
      .def("to_json", [](const Comparison& c) { return ComparisonJson(c.motions, c.metrics); })
      .def(
          "report_html", [](const Comparison& c) { return ComparisonPage(c.a, c.b, c.motions, c.metrics); },
          "Self-contained HTML page with both motions in shared plots.")
      .def("__str__", [](const Comparison& c) { return ComparisonText(c.motions, c.metrics); })
      .def("__repr__", [](const Comparison& c) {
        return fmt::format("<gaitwright.Comparison: {}>",
                           c.motions.same() ? "the same" : FirstDifferenceText(c.motions));
      });
  module.def("compare", Compare, py::arg("a"), py::arg("b"), py::kw_only(), py::arg("align") = "auto",
             py::arg("tolerance") = 0.05,
             R"(Compares two motions: plans, playbacks, or one of each.

Args:
    align: time alignment: "none", "start", "best", or "auto" (docs/compare.md).
    tolerance: share of the scale of each quantity; smaller differences are ignored.)");
}

}  // namespace gaitwright::python
