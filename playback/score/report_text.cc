// SPDX-License-Identifier: BSD-3-Clause
#include "playback/score/report_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "planning/plan/json_part_internal.h"

namespace gaitwright {
namespace {

constexpr double kNothing = 1e-5;  // [rad]: shown as zero, without a sign

using Json = nlohmann::ordered_json;

Json ValueJson(const Metric& metric) {
  if (metric.key == "fell" && metric.value) return *metric.value > 0.0;
  if (metric.key == "scuffs" && metric.value) return static_cast<int>(*metric.value);
  return JsonOrNull(metric.value);
}

Json MetricJson(const Metric& metric) {
  Json json;
  json["value"] = ValueJson(metric);
  if (metric.planned) json["planned"] = JsonOrNull(metric.planned);
  json["unit"] = metric.unit;
  json["limit"] = JsonOrNull(metric.limit);
  json["pass"] = metric.pass;
  json["at_s"] = JsonOrNull(metric.at_s);
  if (!metric.not_applied.empty()) json["not_applied"] = metric.not_applied;
  return json;
}

/// Rows of the estimate are omitted if the controller does not estimate, and those of commands for other plans.
bool IsLeftOut(const Metric& metric) {
  return !metric.value && (metric.key.starts_with("estimate_") || metric.key.starts_with("command_"));
}

bool IsShare(const std::string& key) {
  return key.find("fraction") != std::string::npos || key.find("_use_") != std::string::npos;
}

std::string Mark(const Metric& metric) { return !metric.applied ? " " : (metric.pass ? "+" : "X"); }

std::string OrDash(const Metric& metric, const std::optional<double>& value) {
  return value ? FigureText(metric, *value) : "-";
}

/// The gates that do not apply, with reasons, and the notes.
std::string AbsentGates(const StabilityReport& report) {
  std::string text;
  for (const Metric& metric : report.metrics) {
    if (metric.bound != Bound::kNone && !metric.applied && !IsLeftOut(metric))
      text += fmt::format("  {}: {}\n", metric.key, metric.not_applied);
  }
  if (!text.empty()) text = "\ngates that do not apply:\n" + text;
  for (const std::string& note : report.notes) text += "note: " + note + "\n";
  return text;
}

}  // namespace

std::string FigureText(const Metric& metric, double value) {
  if (metric.unit == "rad" && std::abs(value) < kNothing) value = 0.0;
  if (!std::isfinite(value)) return "not finite";
  if (metric.key == "fell") return value > 0.0 ? "yes" : "no";
  if (metric.key == "scuffs") return fmt::format("{:.0f}", value);
  if (metric.key == "distance_m") return fmt::format("{:.3f} m", value);
  if (metric.unit == "m") return fmt::format("{:.{}f} mm", 1e3 * value, value != 0.0 && std::abs(value) < 1e-3 ? 2 : 1);
  if (metric.key == "contact_timing_error_max_s") return fmt::format("{:.0f} ms", 1e3 * value);
  if (IsShare(metric.key)) return fmt::format("{:.1f} %", 1e2 * value);
  if (metric.unit == "1") return fmt::format("{:.2f}", value);
  if (metric.unit == "rad") return fmt::format("{:.4f} rad", value);
  return std::abs(value) >= 100.0 ? fmt::format("{:.0f} {}", value, metric.unit)
                                  : fmt::format("{:.3f} {}", value, metric.unit);
}

std::string LimitText(const Metric& metric) {
  if (metric.bound == Bound::kNone) return "-";
  if (!metric.applied) return "n/a";
  const char* sign = metric.bound == Bound::kAtMost ? "<=" : (metric.bound == Bound::kAtLeast ? ">=" : ">");
  return metric.key == "fell" ? "no" : fmt::format("{} {}", sign, FigureText(metric, *metric.limit));
}

std::string ReportText(const StabilityReport& report) {
  std::string text = fmt::format("{}   score {:.1f} of 100   robot {}\n{}\n\n", report.pass ? "PASS" : "FAIL",
                                 report.score, report.robot, report.reason);
  text += fmt::format("  {:<28} {:>14} {:>14} {:>14} {:>9}\n", "metric", "measured", "planned", "limit", "worst at");
  for (const Metric& metric : report.metrics) {
    if (IsLeftOut(metric)) continue;
    const std::string at = metric.at_s ? fmt::format("{:.2f} s", *metric.at_s) : "";
    text += fmt::format("{} {:<28} {:>14} {:>14} {:>14} {:>9}\n", Mark(metric), metric.key,
                        OrDash(metric, metric.value), OrDash(metric, metric.planned), LimitText(metric), at);
  }
  return text + AbsentGates(report);
}

std::string ReportText(const StabilityReport& report, const StabilityReport& second, const Agreement& agreement) {
  const auto verdict = [](const std::string& engine, const StabilityReport& of) {
    return fmt::format("{}: {}, {:.1f}: {}\n", engine, of.pass ? "pass" : "fail", of.score, of.reason);
  };
  std::string text = fmt::format("{}   score {:.1f} of 100   robot {}\n", report.pass && second.pass ? "PASS" : "FAIL",
                                 std::min(report.score, second.score), report.robot);
  text += verdict(EngineTitle(agreement.name_a), report) + verdict(EngineTitle(agreement.name_b), second);
  text += AgreementText(agreement) + "\n\n";
  text += fmt::format("   {:<28} {:>14} {:>14} {:>14} {:>14}\n", "metric", EngineTitle(agreement.name_a),
                      EngineTitle(agreement.name_b), "planned", "limit");
  for (const Metric& metric : report.metrics) {
    const Metric& other = second.At(metric.key);
    if (IsLeftOut(metric) && IsLeftOut(other)) continue;
    text += fmt::format("{}{} {:<28} {:>14} {:>14} {:>14} {:>14}\n", Mark(metric), Mark(other), metric.key,
                        OrDash(metric, metric.value), OrDash(other, other.value), OrDash(metric, metric.planned),
                        LimitText(metric));
  }
  return text + AbsentGates(report);
}

std::string ReportJson(const StabilityReport& report) {
  Json json;
  json["robot"] = report.robot;
  json["verdict"] = report.pass ? "pass" : "fail";
  json["score"] = report.score;
  json["reason"] = report.reason;
  json["metrics"] = Json::object();
  for (const Metric& metric : report.metrics) json["metrics"][metric.key] = MetricJson(metric);
  json["notes"] = report.notes;
  return json.dump(2);
}

}  // namespace gaitwright
