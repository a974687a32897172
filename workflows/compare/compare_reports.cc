// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/compare/compare_reports.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "planning/plan/json_part_internal.h"
#include "playback/score/stability_report.h"

namespace gaitwright {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kLeastReportDifference = 1e-9;

/// A number or a boolean; nothing for null.
std::optional<double> FigureOf(const Json& json) {
  if (json.is_null()) return std::nullopt;
  if (json.is_boolean()) return json.get<bool>() ? 1.0 : 0.0;
  return json.get<double>();
}

std::vector<std::string> LawsOf(const Json& report) {
  std::vector<std::string> laws;
  if (!report.contains("audit")) return laws;
  for (const Json& violation : report.at("audit").at("violations")) {
    const auto law = violation.at("law").get<std::string>();
    if (std::find(laws.begin(), laws.end(), law) == laws.end()) laws.push_back(law);
  }
  return laws;
}

ReadReport Read(const Json& json) {
  ReadReport report;
  report.robot = json.at("robot").get<std::string>();
  report.verdict = json.at("verdict").get<std::string>();
  report.reason = json.at("reason").get<std::string>();
  report.score = json.at("score").get<double>();
  for (const auto& [key, metric] : json.at("metrics").items()) {
    if (key.empty()) throw InvalidArgument("a metric has no name");
    report.metrics.push_back({key, metric.at("unit").get<std::string>(), FigureOf(metric.at("value")),
                              FigureOf(metric.at("limit")), metric.at("pass").get<bool>()});
  }
  report.violations = LawsOf(json);
  return report;
}

MetricPair Paired(MetricPair pair, double tolerance) {
  if (pair.a && pair.b) {
    const double scale = std::max({std::abs(*pair.a), std::abs(*pair.b), std::abs(pair.limit.value_or(0.0))});
    pair.differs = std::abs(*pair.b - *pair.a) > std::max(tolerance * scale, kLeastReportDifference);
  }
  pair.differs = pair.differs || pair.a.has_value() != pair.b.has_value() || pair.pass_a != pair.pass_b;
  return pair;
}

void AddWord(const std::string& key, const std::string& a, const std::string& b, std::vector<WordDifference>& words) {
  if (a != b) words.push_back({key, a, b});
}

std::string Joined(const std::vector<std::string>& laws) { return fmt::format("{}", fmt::join(laws, ", ")); }

}  // namespace

Result<ReadReport> ReportFromJson(const std::string& text, const std::string& source) {
  const auto refused = [&](const std::string& why) {
    return Failure{FailureKind::kBadInput,
                   FailureCode::kReportFile,
                   "ReadReport",
                   fmt::format("'{}' is refused: {}", source, why),
                   {}};
  };
  try {
    ReadReport report = Read(ParseJsonOnce(text));
    report.name = source;
    return report;
  } catch (const Json::parse_error&) {
    return refused(ReasonNoJson(text));
  } catch (const InvalidArgument& error) {
    return refused(error.what());
  } catch (const Json::exception& error) {
    return refused(fmt::format("a part is missing or of the wrong kind: {}", error.what()));
  }
}

bool ReportComparison::same() const {
  return words.empty() && std::none_of(metrics.begin(), metrics.end(), [](const MetricPair& m) { return m.differs; });
}

ReportComparison CompareReports(const ReadReport& a, const ReadReport& b, double tolerance) {
  ReportComparison comparison;
  comparison.name_a = a.name;
  comparison.name_b = b.name;
  comparison.score_a = a.score;
  comparison.score_b = b.score;
  AddWord("robot", a.robot, b.robot, comparison.words);
  AddWord("verdict", a.verdict, b.verdict, comparison.words);
  AddWord("failed checks", Joined(a.violations), Joined(b.violations), comparison.words);
  if (a.verdict != b.verdict) AddWord("reason", a.reason, b.reason, comparison.words);
  const auto find = [](const ReadReport& report, const std::string& key) {
    return std::find_if(report.metrics.begin(), report.metrics.end(), [&](const auto& m) { return m.key == key; });
  };
  for (const ReportedFigure& one : a.metrics) {
    const auto other = find(b, one.key);
    const bool both = other != b.metrics.end();
    comparison.metrics.push_back(
        Paired({one.key, one.unit, one.value, both ? other->value : std::nullopt,
                one.limit ? one.limit : (both ? other->limit : std::nullopt), one.pass, both ? other->pass : one.pass},
               tolerance));
  }
  for (const ReportedFigure& other : b.metrics) {
    if (find(a, other.key) == a.metrics.end())
      comparison.metrics.push_back(
          Paired({other.key, other.unit, std::nullopt, other.value, other.limit, other.pass, other.pass}, tolerance));
  }
  return comparison;
}

std::vector<MetricPair> MetricsOf(const ComparedMotion& a, const ComparedMotion& b, const MotionPlan* played,
                                  double tolerance) {
  std::vector<MetricPair> pairs;
  const auto belongs = [](const ComparedMotion& log, const MotionPlan& plan) {
    return log.log->robot_hash == plan.robot_hash;
  };
  if ((a.plan && b.log) || (a.log && b.plan)) {
    const ComparedMotion &log = a.log ? a : b, &plan = a.log ? b : a;
    if (!belongs(log, *plan.plan)) return pairs;
    for (const Metric& metric : Score(log.model, *plan.plan, *log.log).metrics) {
      if (!metric.planned && !metric.value) continue;
      const auto& of_a = a.plan ? metric.planned : metric.value;
      const auto& of_b = a.plan ? metric.value : metric.planned;
      pairs.push_back({metric.key, metric.unit, of_a, of_b, metric.limit, a.plan ? true : metric.pass,
                       a.plan ? metric.pass : true, false});
    }
  }
  if (!a.log || !b.log || played == nullptr || !belongs(a, *played) || !belongs(b, *played)) return pairs;
  const StabilityReport report_a = Score(a.model, *played, *a.log), report_b = Score(b.model, *played, *b.log);
  for (std::size_t i = 0; i < report_a.metrics.size(); ++i) {
    const Metric &one = report_a.metrics[i], &other = report_b.metrics[i];
    if (one.value || other.value)
      pairs.push_back(Paired({one.key, one.unit, one.value, other.value, one.limit, one.pass, other.pass}, tolerance));
  }
  return pairs;
}

}  // namespace gaitwright
