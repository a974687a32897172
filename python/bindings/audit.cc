// SPDX-License-Identifier: BSD-3-Clause
#include "planning/audit/audit.h"

#include <fmt/format.h>
#include <pybind11/stl.h>

#include "python/bindings/bindings.h"
#include "python/bindings/errors.h"
#include "python/bindings/options.h"
#include "python/bindings/plan.h"

namespace gaitwright::python {
namespace {

namespace py = pybind11;

AuditReport AuditOf(const Plan& plan, bool margins, const py::dict& options) {
  AuditOptions audit;
  audit.margins = margins;
  SetOptions(audit.Fields(), options);
  const py::gil_scoped_release others_go_on;
  return Value(Audit(plan.model(), plan.motion(), audit));
}

}  // namespace

void BindAudit(py::module_& module) {
  py::class_<Violation>(module, "Violation", "A failed check of a plan, at its worst place.")
      .def_property_readonly("law", [](const Violation& v) { return LawName(v.law); })
      .def_readonly("at_s", &Violation::at_s)
      .def_readonly("where", &Violation::where, "Joint, foot or pair of links.")
      .def_readonly("value", &Violation::value)
      .def_readonly("limit", &Violation::limit)
      .def_readonly("unit", &Violation::unit)
      .def("__repr__", [](const Violation& v) {
        return fmt::format("<gaitwright.Violation {} at {:.3f} s, {}: {:.4g} over {:.4g} {}>", LawName(v.law), v.at_s,
                           v.where, v.value, v.limit, v.unit);
      });
  py::class_<AuditMargin>(module, "AuditMargin", "Margin of a plan to the limit of a check at one place.")
      .def_property_readonly("law", [](const AuditMargin& m) { return LawName(m.law); })
      .def_readonly("at_s", &AuditMargin::at_s, "Time of the smallest margin [s].")
      .def_readonly("where", &AuditMargin::where)
      .def_readonly("value", &AuditMargin::value)
      .def_readonly("limit", &AuditMargin::limit)
      .def_readonly("margin", &AuditMargin::margin, "From the value to the limit; negative beyond it.")
      .def_readonly("unit", &AuditMargin::unit);
  py::class_<AuditReport>(module, "AuditReport", "Result of the dense check of a plan: all failed checks.")
      .def_property_readonly("passed", &AuditReport::pass)
      .def_readonly("violations", &AuditReport::violations,
                    "Violations by check in a fixed order, then the worst first.")
      .def_readonly("margins", &AuditReport::margins, "Margins, if requested: by check, then the smallest first.")
      .def_readonly("notes", &AuditReport::notes, "Limits that are placeholders, and checks that could not be applied.")
      .def_readonly("remarks", &AuditReport::remarks, "Likely causes of failed checks, with remedies.")
      .def_readonly("samples", &AuditReport::samples)
      .def("to_json", AuditJson)
      .def("__str__", AuditText)
      .def("__bool__", &AuditReport::pass)
      .def("__repr__", [](const AuditReport& report) {
        return fmt::format("<gaitwright.AuditReport {}: {} violations, {} samples>", report.pass() ? "pass" : "fail",
                           report.violations.size(), report.samples);
      });
  module.attr("AUDIT_LAWS") = LawNames();
  module.attr("FAILURE_CODES") = FailureCodeNames();
  module.def("audit", AuditOf, py::arg("plan").none(false), py::arg("margins") = false, py::arg("options") = py::dict(),
             R"(Checks a plan at 1 kHz, also between its nodes: dynamics, forces, limits, reach, clearance and more.

Args:
    margins: also report the smallest margin of each check.
    options: as for ``gaitwright audit --set``, such as ``{"derate_torque": 0.8}``.)");
}

}  // namespace gaitwright::python
