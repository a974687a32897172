// SPDX-License-Identifier: BSD-3-Clause
#include "playback/trials/robustness_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "kinematics/base/result.h"
#include "playback/score/gates.h"

namespace gaitwright {
namespace {

constexpr std::size_t kWorstShown = 10;

/// Interpolated quantile of sorted values; `share` from 0 (first) to 1 (last).
double Quantile(const std::vector<double>& sorted, double share) {
  const double place = share * static_cast<double>(sorted.size() - 1);
  const std::size_t low = static_cast<std::size_t>(place), high = std::min(low + 1, sorted.size() - 1);
  return sorted[low] + (place - static_cast<double>(low)) * (sorted[high] - sorted[low]);
}

std::vector<MetricSpread> Spreads(const TrialSubject& subject, const std::vector<TrialOutcome>& outcomes) {
  std::vector<MetricSpread> spreads;
  for (const MetricRule& rule : MetricRules()) {
    std::vector<double> values;
    bool gated = false;
    MetricSpread spread{rule.key, rule.unit};
    for (const TrialOutcome& outcome : outcomes) {
      for (const auto& [key, value] : outcome.metrics) {
        if (key == rule.key && value) values.push_back(*value);
      }
      gated |= std::count(outcome.gates.begin(), outcome.gates.end(), rule.key) > 0;
      spread.broken += static_cast<int>(std::count(outcome.broken_gates.begin(), outcome.broken_gates.end(), rule.key));
    }
    if (values.empty()) continue;
    for (const auto& [key, limit] : subject.limits) {
      if (gated && key == rule.key) spread.limit = limit;
    }
    std::sort(values.begin(), values.end());
    spread.n = static_cast<int>(values.size());
    spread.lowest = values.front();
    spread.p05 = Quantile(values, 0.05);
    spread.median = Quantile(values, 0.5);
    spread.p95 = Quantile(values, 0.95);
    spread.highest = values.back();
    spreads.push_back(spread);
  }
  return spreads;
}

std::vector<Tally> Sorted(const std::map<std::string, int>& counts) {
  std::vector<Tally> tallies;
  for (const auto& [what, count] : counts) tallies.push_back({what, count});
  std::stable_sort(tallies.begin(), tallies.end(), [](const Tally& a, const Tally& b) { return a.count > b.count; });
  return tallies;
}

void CountCauses(RobustnessReport& report) {
  std::map<std::string, int> causes, gates;
  for (const TrialOutcome& outcome : report.outcomes) {
    if (!outcome.survived) ++causes[outcome.cause];
    if (!outcome.survived || outcome.passed) continue;
    for (const std::string& gate : outcome.broken_gates) ++gates[gate];
  }
  report.causes = Sorted(causes);
  report.broken_gates = Sorted(gates);
}

/// Values of every name that all trials have, in their order; directions are omitted, because their components are
/// listed.
std::vector<SampledColumn> ColumnsOf(const std::vector<TrialOutcome>& outcomes) {
  std::vector<SampledColumn> columns;
  for (const SampledValue& first : outcomes.front().sampled) {
    SampledColumn column{first.name, first.unit, {}, {}};
    for (const TrialOutcome& outcome : outcomes) {
      for (const SampledValue& one : outcome.sampled) {
        if (one.name != first.name) continue;
        one.word.empty() ? column.values.push_back(one.value) : column.words.push_back(one.word);
      }
    }
    const bool seed = first.name == "bump_seed", direction = first.name.ends_with("direction_deg");
    if (!seed && !direction && std::max(column.values.size(), column.words.size()) == outcomes.size())
      columns.push_back(std::move(column));
  }
  return columns;
}

GaitSensitivity GaitSensitivityOf(const TrialSubject& subject, const std::vector<TrialOutcome>& outcomes) {
  std::vector<std::vector<GaitStep>> steps;
  for (const TrialOutcome& outcome : outcomes) {
    if (outcome.survived) steps.push_back(outcome.steps);
  }
  return EstimateGaitSensitivity(steps, subject.gait_scale);
}

/// Falls first, then failures, then passes; each group by score.
std::vector<int> WorstOf(const std::vector<TrialOutcome>& outcomes) {
  std::vector<int> numbers;
  for (const TrialOutcome& outcome : outcomes) numbers.push_back(outcome.number);
  const auto worse = [&](int a, int b) {
    const TrialOutcome &x = outcomes[static_cast<std::size_t>(a)], &y = outcomes[static_cast<std::size_t>(b)];
    return std::tuple(x.survived, x.passed, x.score) < std::tuple(y.survived, y.passed, y.score);
  };
  std::stable_sort(numbers.begin(), numbers.end(), worse);
  if (numbers.size() > kWorstShown) numbers.resize(kWorstShown);
  return numbers;
}

}  // namespace

RobustnessReport ReduceTrials(const TrialSubject& subject, std::vector<TrialOutcome> outcomes) {
  RobustnessReport report;
  report.subject = subject;
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    if (outcomes[i].number != static_cast<int>(i))
      throw InvalidArgument(
          fmt::format("outcome {} belongs to trial {}; outcomes must be in order", i, outcomes[i].number));
    report.survived += outcomes[i].survived ? 1 : 0;
    report.passed += outcomes[i].passed ? 1 : 0;
  }
  report.n = static_cast<int>(outcomes.size());
  report.outcomes = std::move(outcomes);
  report.survival = WilsonInterval(report.survived, report.n);
  report.pass_share = WilsonInterval(report.passed, report.n);
  if (report.n == 0) return report;
  report.metrics = Spreads(subject, report.outcomes);
  CountCauses(report);
  std::vector<char> fell;
  std::set<std::string> logs;
  for (const TrialOutcome& outcome : report.outcomes) {
    fell.push_back(outcome.survived ? 0 : 1);
    logs.insert(outcome.log_hash);
  }
  report.different = static_cast<int>(logs.size());
  report.sensitivity = RankDisturbances(ColumnsOf(report.outcomes), fell);
  for (const TrialOutcome& outcome : report.outcomes) {
    for (const PushRecord& push : PushesOf(outcome, report.subject.own_push_s)) report.pushes.push_back(push);
  }
  report.push_bins = PushBins(report.pushes);
  report.gait_sensitivity = GaitSensitivityOf(subject, report.outcomes);
  report.worst = WorstOf(report.outcomes);
  return report;
}

}  // namespace gaitwright
