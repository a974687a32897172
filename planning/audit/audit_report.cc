// SPDX-License-Identifier: BSD-3-Clause
#include "planning/audit/audit_report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace gaitwright {

const std::vector<std::string>& AuditLaws() {
  static const std::vector<std::string> laws = {"consistency",    "joint_position", "joint_velocity", "reach",
                                                "self_collision", "foot_clearance", "body_clearance", "zmp_support",
                                                "unilateral",     "friction_cone",  "dynamics",       "joint_torque"};
  return laws;
}

std::string AuditText(const AuditReport& report) {
  if (report.pass()) return fmt::format("audit: pass, {} samples at {:.0f} Hz\n", report.samples, report.rate_hz);
  std::string text =
      fmt::format("audit: fail, {} violations in {} samples\n", report.violations.size(), report.samples);
  for (const Violation& v : report.violations) {
    text += fmt::format("  {:<15} at {:6.3f} s  {}: {:.4g} {} (limit {:.4g})\n", v.law, v.at_s, v.where, v.value,
                        v.unit, v.limit);
  }
  return text;
}

std::string AuditJson(const AuditReport& report) {
  nlohmann::ordered_json violations = nlohmann::ordered_json::array();
  for (const Violation& v : report.violations) {
    violations.push_back({{"law", v.law},
                          {"at_s", v.at_s},
                          {"where", v.where},
                          {"value", v.value},
                          {"limit", v.limit},
                          {"unit", v.unit}});
  }
  const nlohmann::ordered_json json = {{"verdict", report.pass() ? "pass" : "fail"},
                                       {"violations", violations},
                                       {"samples", report.samples},
                                       {"notes", report.notes}};
  return json.dump(2);
}

}  // namespace gaitwright
