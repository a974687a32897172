// SPDX-License-Identifier: BSD-3-Clause
#include "playback/trials/robustness_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "kinematics/base/result.h"
#include "playback/score/gates.h"

namespace gaitwright {
namespace {

constexpr int kDirections = 8;
constexpr std::size_t kWorstTold = 10;

/// Between the two nearest of sorted values, as share of the way from first to last.
double Quantile(const std::vector<double>& sorted, double share) {
  const double place = share * static_cast<double>(sorted.size() - 1);
  const std::size_t low = static_cast<std::size_t>(place), high = std::min(low + 1, sorted.size() - 1);
  return sorted[low] + (place - static_cast<double>(low)) * (sorted[high] - sorted[low]);
}

std::vector<MetricSpread> Spreads(const TrialSubject& subject, const std::vector<TrialOutcome>& outcomes) {
  std::vector<MetricSpread> spreads;
  for (const MetricRule& rule : MetricRules()) {
    std::vector<double> values;
    MetricSpread spread{rule.key, rule.unit};
    for (const TrialOutcome& outcome : outcomes) {
      for (const auto& [key, value] : outcome.metrics) {
        if (key == rule.key && value) values.push_back(*value);
      }
      spread.broken += static_cast<int>(std::count(outcome.broken_gates.begin(), outcome.broken_gates.end(), rule.key));
    }
    if (values.empty()) continue;
    for (const auto& [key, limit] : subject.limits) {
      if (key == rule.key) spread.limit = limit;
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

/// Values of every name that all trials have, in their order; a push's direction is left to its parts.
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

std::vector<PushRecord> PushesOf(const TrialOutcome& outcome) {
  std::vector<PushRecord> pushes;
  std::string name;
  for (const SampledValue& one : outcome.sampled) {
    const std::size_t dot = one.name.find('.');
    if (!one.name.starts_with("push") || dot == std::string::npos) continue;
    if (one.name.substr(0, dot) != name) pushes.emplace_back();
    name = one.name.substr(0, dot);
    const std::string part = one.name.substr(dot + 1);
    if (part == "ahead_n") pushes.back().ahead_n = one.value;
    if (part == "left_n") pushes.back().left_n = one.value;
    if (part == "at_s") pushes.back().at_s = one.value;
    if (part == "duration_s") pushes.back().duration_s = one.value;
  }
  std::erase_if(pushes, [&](const PushRecord& p) { return !outcome.survived && p.at_s > outcome.ended_s; });
  for (PushRecord& push : pushes) push.fatal = !outcome.survived;
  return pushes;
}

void BinPushes(RobustnessReport& report) {
  constexpr double kWidth = 360.0 / kDirections;
  for (const TrialOutcome& outcome : report.outcomes) {
    for (const PushRecord& push : PushesOf(outcome)) report.pushes.push_back(push);
  }
  if (report.pushes.empty()) return;
  for (int i = 0; i < kDirections; ++i) report.push_bins.push_back({kWidth * i, 0, 0, {}, {}});
  for (const PushRecord& push : report.pushes) {
    const double size = push.size_n();
    if (size == 0.0) continue;
    const double direction = std::atan2(push.left_n, push.ahead_n) * 180.0 / std::numbers::pi;
    const int i = (static_cast<int>(std::lround(direction / kWidth)) + kDirections) % kDirections;
    PushBin& bin = report.push_bins[static_cast<std::size_t>(i)];
    ++bin.n;
    bin.fell += push.fatal ? 1 : 0;
    if (push.fatal) bin.smallest_fatal_n = std::min(bin.smallest_fatal_n.value_or(size), size);
    if (!push.fatal) bin.largest_survived_n = std::max(bin.largest_survived_n.value_or(size), size);
  }
}

/// Falls, the earliest first, then failures by their score; passes are not bad.
std::vector<int> WorstOf(const std::vector<TrialOutcome>& outcomes) {
  std::vector<int> numbers;
  for (const TrialOutcome& outcome : outcomes) {
    if (!outcome.passed) numbers.push_back(outcome.number);
  }
  const auto worse = [&](int a, int b) {
    const TrialOutcome &x = outcomes[static_cast<std::size_t>(a)], &y = outcomes[static_cast<std::size_t>(b)];
    return x.survived != y.survived ? !x.survived : x.score < y.score;
  };
  std::stable_sort(numbers.begin(), numbers.end(), worse);
  if (numbers.size() > kWorstTold) numbers.resize(kWorstTold);
  return numbers;
}

}  // namespace

double PushRecord::size_n() const { return std::hypot(ahead_n, left_n); }

RobustnessReport ReduceTrials(const TrialSubject& subject, std::vector<TrialOutcome> outcomes) {
  RobustnessReport report;
  report.subject = subject;
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    if (outcomes[i].number != static_cast<int>(i))
      throw InvalidArgument(fmt::format("outcome {} is of trial {}; they must be in order", i, outcomes[i].number));
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
  for (const TrialOutcome& outcome : report.outcomes) fell.push_back(outcome.survived ? 0 : 1);
  report.sensitivity = RankDisturbances(ColumnsOf(report.outcomes), fell);
  BinPushes(report);
  report.worst = WorstOf(report.outcomes);
  return report;
}

}  // namespace gaitwright
