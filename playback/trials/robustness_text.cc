// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "planning/plan/json_part_internal.h"
#include "playback/score/gates.h"
#include "playback/trials/robustness_report.h"

namespace gaitwright {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostReported = 8;  // largest number of ranked quantities in the text

Json MetricsJson(const RobustnessReport& report) {
  Json metrics = Json::object();
  for (const MetricSpread& m : report.metrics) {
    metrics[m.key] = {{"unit", m.unit},     {"n", m.n},     {"min", m.lowest},  {"p05", m.p05},
                      {"median", m.median}, {"p95", m.p95}, {"max", m.highest}, {"limit", JsonOrNull(m.limit)},
                      {"broken", m.broken}};
  }
  return metrics;
}

Json TallyJson(const std::vector<Tally>& tallies) {
  Json json = Json::object();
  for (const Tally& tally : tallies) json[tally.what] = tally.count;
  return json;
}

Json SensitivityJson(const RobustnessReport& report) {
  Json list = Json::array();
  for (const Sensitivity& s : report.sensitivity) {
    list.push_back({{"name", s.name},
                    {"unit", s.unit},
                    {"falls_with", s.how},
                    {"effect", s.effect},
                    {"p", s.p},
                    {"log_odds_per_std", s.weight},
                    {"median_fell", s.median_fell},
                    {"median_survived", s.median_survived}});
  }
  return list;
}

Json PushesJson(const RobustnessReport& report) {
  Json list = Json::array();
  for (const PushBin& bin : report.push_bins) {
    list.push_back({{"direction_deg", bin.direction_deg},
                    {"n", bin.n},
                    {"fell", bin.fell},
                    {"unknown", bin.unknown},
                    {"largest_survived_n", JsonOrNull(bin.largest_survived_n)},
                    {"smallest_fatal_n", JsonOrNull(bin.smallest_fatal_n)}});
  }
  return list;
}

Json GaitSensitivityJson(const GaitSensitivity& gait) {
  Json response = Json::array();
  for (const GaitSensitivity::Response& matrix : gait.response) {
    Json rows = Json::array();
    for (Eigen::Index row = 0; row < matrix.rows(); ++row) {
      rows.push_back(Json::array());
      for (Eigen::Index column = 0; column < matrix.cols(); ++column) rows.back().push_back(matrix(row, column));
    }
    response.push_back(std::move(rows));
  }
  return {{"standard_error", JsonOrNull(gait.standard_error)},
          {"missing", gait.missing},
          {"trials", gait.trials},
          {"steps", gait.steps},
          {"indicators", kStepIndicators},
          {"disturbances", kStepDisturbances},
          {"varied", gait.varied},
          {"response", response}};
}

Json SampledJson(const TrialOutcome& outcome) {
  Json sampled = Json::object();
  for (const SampledValue& one : outcome.sampled)
    sampled[one.name] = one.word.empty() ? Json(one.value) : Json(one.word);
  return sampled;
}

Json WorstJson(const RobustnessReport& report) {
  Json list = Json::array();
  for (const int number : report.worst) {
    const TrialOutcome& o = report.Outcome(number);
    list.push_back({{"seed", o.seed},
                    {"number", o.number},
                    {"survived", o.survived},
                    {"score", o.score},
                    {"ended_s", o.ended_s},
                    {"cause", o.cause},
                    {"reason", o.reason},
                    {"log_hash", o.log_hash},
                    {"sampled", SampledJson(o)}});
  }
  return list;
}

/// One row per trial; data that all trials share are written once.
Json TrialsJson(const RobustnessReport& report) {
  Json columns = {"seed", "survived", "passed", "score", "ended_s", "cause", "log_hash"};
  if (report.n > 0) {
    for (const SampledValue& one : report.outcomes.front().sampled) columns.push_back(one.name);
  }
  Json rows = Json::array();
  for (const TrialOutcome& o : report.outcomes) {
    Json row = {o.seed, o.survived, o.passed, o.score, o.ended_s, o.cause, o.log_hash};
    for (const SampledValue& one : o.sampled) row.push_back(one.word.empty() ? Json(one.value) : Json(one.word));
    rows.push_back(std::move(row));
  }
  return {{"columns", columns}, {"rows", rows}};
}

std::vector<std::string> Remarks(const RobustnessReport& report) {
  const std::string repeats = RepeatsText(report);
  return repeats.empty() ? std::vector<std::string>() : std::vector<std::string>{repeats};
}

std::string Percent(double share) { return fmt::format("{:.1f} %", 100.0 * share); }

std::string Share(const char* what, int k, int n, const ShareInterval& interval) {
  return fmt::format("{:<10}{} of {}: {}, 95 % interval {} to {}\n", what, k, n, Percent(interval.share),
                     Percent(interval.low), Percent(interval.high));
}

std::string SensitivityLines(const RobustnessReport& report) {
  if (report.survived == 0 && report.n > 1) return "\ncorrelates of falling: not available, because every trial fell\n";
  if (report.sensitivity.empty()) return "";
  std::string text = "\ncorrelates of falling (effect 0 to 1, p-value)\n";
  for (std::size_t i = 0; i < std::min(kMostReported, report.sensitivity.size()); ++i) {
    const Sensitivity& s = report.sensitivity[i];
    text += fmt::format("  {:<36} {:<10} effect {:.2f}  p {:.2g}", s.name, s.how, s.effect, s.p);
    if (!s.of_a_word) {
      text += fmt::format("  median {:.4g} if fell, {:.4g} if not [{}]", s.median_fell, s.median_survived, s.unit);
    }
    text += "\n";
  }
  return text;
}

/// "ground_height and push_left": the disturbances that varied.
std::string VariedWords(const GaitSensitivity& gait) {
  std::string words;
  for (std::size_t d = 0; d < gait.varied.size(); ++d) {
    if (gait.varied[d]) words += (words.empty() ? "" : ", ") + std::string(kStepDisturbances[d]);
  }
  return words;
}

std::string GaitSensitivityLine(const GaitSensitivity& gait) {
  if (!gait.norm) return fmt::format("\ngait sensitivity norm: not available, {}\n", gait.missing);
  return fmt::format("\ngait sensitivity norm {:.3g}, standard error {:.2g}, of step time and foot placement to {}\n",
                     *gait.norm, *gait.standard_error, VariedWords(gait));
}

std::string PushLines(const RobustnessReport& report) {
  if (report.push_bins.empty()) return "";
  std::string text = "\npushes by direction (0 forward, 90 to the left)\n";
  for (const PushBin& bin : report.push_bins) {
    const auto size = [](const std::optional<double>& n) { return n ? fmt::format("{:.1f} N", *n) : std::string("-"); };
    text += fmt::format("  {:>3.0f} deg  {:>4} pushes, {:>3} fell; largest survived {:>8}, smallest fatal {:>8}{}\n",
                        bin.direction_deg, bin.n, bin.fell, size(bin.largest_survived_n), size(bin.smallest_fatal_n),
                        bin.unknown > 0 ? fmt::format("; {} more undecided", bin.unknown) : "");
  }
  return text;
}

std::string MetricLines(const RobustnessReport& report) {
  std::string text = fmt::format("\n{:<30}{:>12}{:>12}{:>12}{:>12}{:>12}  {}\n", "metric", "min", "5 %", "median",
                                 "95 %", "max", "broken");
  for (const MetricSpread& m : report.metrics) {
    text += fmt::format("{:<30}{:>12.4g}{:>12.4g}{:>12.4g}{:>12.4g}{:>12.4g}  {}\n", m.key, m.lowest, m.p05, m.median,
                        m.p95, m.highest, RuleOf(m.key).bound == Bound::kNone ? "" : fmt::format("{}", m.broken));
  }
  return text;
}

}  // namespace

std::string RobustnessJson(const RobustnessReport& report) {
  Json options = Json::object();
  for (const auto& [key, text] : report.subject.options) options[key] = text;
  const Json json = {{"n", report.n},
                     {"survived", report.survived},
                     {"survival", report.survival.share},
                     {"survival_low", report.survival.low},
                     {"survival_high", report.survival.high},
                     {"different", report.different},
                     {"remarks", Remarks(report)},
                     {"passed", report.passed},
                     {"pass_share", report.pass_share.share},
                     {"pass_low", report.pass_share.low},
                     {"pass_high", report.pass_share.high},
                     {"metrics", MetricsJson(report)},
                     {"causes", TallyJson(report.causes)},
                     {"broken_gates", TallyJson(report.broken_gates)},
                     {"gait_sensitivity_norm", JsonOrNull(report.gait_sensitivity.norm)},
                     {"gait_sensitivity", GaitSensitivityJson(report.gait_sensitivity)},
                     {"sensitivity", SensitivityJson(report)},
                     {"pushes", PushesJson(report)},
                     {"worst", WorstJson(report)},
                     {"robot", report.subject.robot},
                     {"robot_hash", report.subject.robot_hash},
                     {"plan_hash", report.subject.plan_hash},
                     {"whole_plan_hash", report.subject.whole_plan_hash},
                     {"controller", report.subject.controller},
                     {"seed", report.subject.seed},
                     {"disturbances", report.subject.disturbances},
                     {"options", options},
                     {"repeat", report.subject.repeat},
                     {"trials", TrialsJson(report)}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string RepeatsText(const RobustnessReport& report) {
  if (report.different == report.n) return "";
  const std::string counted = "the interval is valid for different trials only; a preflight counts each playback once";
  if (report.different == 1)
    return fmt::format("all {} trials are identical: no sampled disturbance affects the playback; {}", report.n,
                       counted);
  return fmt::format("only {} of {} trials are different playbacks, and the others repeat them; {}", report.different,
                     report.n, counted);
}

std::string RobustnessText(const RobustnessReport& report) {
  std::string text = Share("survived", report.survived, report.n, report.survival) +
                     Share("passed", report.passed, report.n, report.pass_share);
  for (const std::string& remark : Remarks(report)) text += fmt::format("note: {}\n", remark);
  if (!report.causes.empty()) text += "\ncauses of falls\n";
  for (const Tally& tally : report.causes) text += fmt::format("  {:>4}  {}\n", tally.count, tally.what);
  if (!report.broken_gates.empty()) text += "\ngates failed without a fall\n";
  for (const Tally& tally : report.broken_gates) text += fmt::format("  {:>4}  {}\n", tally.count, tally.what);
  text += GaitSensitivityLine(report.gait_sensitivity) + SensitivityLines(report) + PushLines(report);
  if (!report.worst.empty())
    text += fmt::format("\nworst trials; repeat one exactly with: {}\n", report.subject.repeat);
  for (const int number : report.worst) {
    const TrialOutcome& o = report.Outcome(number);
    text += fmt::format("  seed {:>10}  {} {:>6.2f} s  {}\n", o.seed,
                        !o.survived ? "fell at"
                        : o.passed  ? "passed"
                                    : "failed",
                        o.ended_s, o.cause);
  }
  return text + MetricLines(report);
}

}  // namespace gaitwright
