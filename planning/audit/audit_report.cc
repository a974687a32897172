// SPDX-License-Identifier: BSD-3-Clause
#include "planning/audit/audit_report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace gaitwright {
namespace {

nlohmann::ordered_json MarginsJson(const std::vector<AuditMargin>& margins) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const AuditMargin& m : margins) {
    list.push_back({{"law", LawName(m.law)},
                    {"at_s", m.at_s},
                    {"where", m.where},
                    {"value", m.value},
                    {"limit", m.limit},
                    {"unit", m.unit},
                    {"margin", m.margin},
                    {"share", m.share ? nlohmann::ordered_json(*m.share) : nlohmann::ordered_json(nullptr)}});
  }
  return list;
}

std::string MarginsText(const std::vector<AuditMargin>& margins) {
  if (margins.empty()) return "";
  std::string text = "smallest margin of each check and place:\n";
  for (const AuditMargin& m : margins) {
    text += fmt::format("  {:<18} {:>5}  at {:6.3f} s  {}: {} (limit {:.4g})\n", LawName(m.law),
                        m.share ? fmt::format("{:.0f} %", 100.0 * *m.share) : "", m.at_s, m.where,
                        AuditFigure(m.value, m.unit), m.limit);
  }
  return text;
}

}  // namespace

std::vector<AuditMargin> TightestOfEachLaw(const std::vector<AuditMargin>& margins) {
  std::vector<AuditMargin> tightest;
  for (const AuditMargin& margin : margins) {
    if (tightest.empty() || tightest.back().law != margin.law) tightest.push_back(margin);
  }
  return tightest;
}

std::string AuditFigure(double value, const std::string& unit) {
  const double shown = value == 0.0 ? 0.0 : value;  // no minus sign before zero
  return unit == "1" || unit.empty() ? fmt::format("{:.4g}", shown) : fmt::format("{:.4g} {}", shown, unit);
}

std::string AuditText(const AuditReport& report) {
  if (report.samples == 0 && !report.notes.empty()) return fmt::format("audit: none, {}\n", report.notes.front());
  if (report.pass()) {
    return fmt::format("audit: pass, {} samples at {:.0f} Hz\n", report.samples, report.rate_hz) +
           MarginsText(report.margins);
  }
  std::string text = fmt::format("audit: fail, {} violation{} in {} samples\n", report.violations.size(),
                                 report.violations.size() == 1 ? "" : "s", report.samples);
  for (const Violation& v : report.violations) {
    text += fmt::format("  {:<18} at {:6.3f} s  {}: {} (limit {:.4g})\n", LawName(v.law), v.at_s, v.where,
                        AuditFigure(v.value, v.unit), v.limit);
  }
  for (const std::string& remark : report.remarks) text += "  note: " + remark + "\n";
  return text + MarginsText(report.margins);
}

std::string AuditJson(const AuditReport& report) {
  nlohmann::ordered_json violations = nlohmann::ordered_json::array();
  for (const Violation& v : report.violations) {
    violations.push_back({{"law", LawName(v.law)},
                          {"at_s", v.at_s},
                          {"where", v.where},
                          {"value", v.value},
                          {"limit", v.limit},
                          {"unit", v.unit}});
  }
  nlohmann::ordered_json json = {{"verdict", report.pass() ? "pass" : "fail"},
                                 {"violations", violations},
                                 {"samples", report.samples},
                                 {"notes", report.notes}};
  if (!report.remarks.empty()) json["remarks"] = report.remarks;
  if (!report.margins.empty()) json["margins"] = MarginsJson(report.margins);
  return json.dump(2);
}

}  // namespace gaitwright
