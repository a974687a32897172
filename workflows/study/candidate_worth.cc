// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/candidate_worth.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "playback/trials/wilson.h"

namespace gaitwright {
namespace {

using Json = nlohmann::ordered_json;

/// Quantile 0.975 of Student's t.
double StudentQuantile(double degrees) {
  constexpr double z = 1.959963984540054;
  const double z3 = z * z * z, z5 = z3 * z * z, z7 = z5 * z * z;
  return z + (z3 + z) / (4.0 * degrees) + (5.0 * z5 + 16.0 * z3 + 3.0 * z) / (96.0 * degrees * degrees) +
         (3.0 * z7 + 19.0 * z5 + 17.0 * z3 - 15.0 * z) / (384.0 * degrees * degrees * degrees);
}

void CheckPairs(const char* of, const std::vector<double>& before, const std::vector<double>& after) {
  if (before.size() == after.size() && before.size() >= 6) return;
  throw InvalidArgument(fmt::format("{}: {} values before and {} after; equal numbers, six or more, are needed", of,
                                    before.size(), after.size()));
}

/// Numbers of pairs that are true in both, only before, only after, and in neither.
struct PairCounts {
  double both = 0.0, before = 0.0, after = 0.0, neither = 0.0;
};

/// Correlation of both proportions with Newcombe's continuity correction; 0 if all values before, or all after, are
/// equal.
double Correlation(const PairCounts& n) {
  const double half = 0.5 * (n.both + n.before + n.after + n.neither);
  const double product = (n.both + n.before) * (n.after + n.neither) * (n.both + n.after) * (n.before + n.neither);
  const double determinant = n.both * n.neither - n.before * n.after;
  if (product == 0.0) return 0.0;
  return (determinant > 0.0 ? std::max(determinant - half, 0.0) : determinant) / std::sqrt(product);
}

PairCounts CountPairs(const std::vector<double>& before, const std::vector<double>& after) {
  PairCounts n;
  for (std::size_t i = 0; i < before.size(); ++i) {
    for (const double value : {before[i], after[i]}) {
      if (value != 0.0 && value != 1.0)
        throw InvalidArgument(fmt::format("DifferenceOfShares: {} is neither 0 nor 1", value));
    }
    double& count = before[i] == 1.0 ? (after[i] == 1.0 ? n.both : n.before) : (after[i] == 1.0 ? n.after : n.neither);
    ++count;
  }
  return n;
}

}  // namespace

double ValueOf(const TrialWorth& trial, double survival_weight) {
  return trial.score + (trial.survived ? survival_weight : 0.0);
}

std::optional<double> MeanValue(const CandidateWorth& worth, double survival_weight) {
  if (!worth.refusal.empty() || worth.trials.empty()) return std::nullopt;
  double sum = 0.0;
  for (const TrialWorth& trial : worth.trials) sum += ValueOf(trial, survival_weight);
  return sum / static_cast<double>(worth.trials.size());
}

std::string WorthToLine(const CandidateWorth& worth) {
  Json trials = Json::array();
  for (const TrialWorth& trial : worth.trials) trials.push_back({trial.score, trial.survived});
  return Json{{"refusal", worth.refusal}, {"trials", trials}}.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Result<CandidateWorth> WorthFromLine(const std::string& line) {
  try {
    const Json json = Json::parse(line);
    CandidateWorth worth{json.at("refusal").get<std::string>()};
    for (const Json& trial : json.at("trials"))
      worth.trials.push_back({trial.at(0).get<double>(), trial.at(1).get<bool>()});
    const bool scored = std::all_of(worth.trials.begin(), worth.trials.end(),
                                    [](const TrialWorth& trial) { return trial.score >= 0.0 && trial.score <= 100.0; });
    if (!scored || (!worth.refusal.empty() && !worth.trials.empty()))
      throw InvalidArgument("a score is outside 0 to 100, or a refused candidate has trials");
    return worth;
  } catch (const std::exception& error) {  // thrown by the JSON reader
    return Failure{FailureKind::kBadInput,
                   FailureCode::kJournalLine,
                   "WorthFromLine",
                   fmt::format("a line of the journal is not a candidate: {}", error.what()),
                   {}};
  }
}

PairedDifference DifferenceOf(const std::vector<double>& before, const std::vector<double>& after) {
  CheckPairs("DifferenceOf", before, after);
  const auto n = static_cast<double>(before.size());
  PairedDifference d;
  for (std::size_t i = 0; i < before.size(); ++i) {
    d.before += before[i];
    d.after += after[i];
  }
  d.before /= n;  // divide once, so that the mean of ones is exactly one
  d.after /= n;
  d.mean = d.after - d.before;
  double squares = 0.0;
  for (std::size_t i = 0; i < before.size(); ++i) squares += std::pow(after[i] - before[i] - d.mean, 2);
  const double half = StudentQuantile(n - 1.0) * std::sqrt(squares / (n - 1.0) / n);
  d.low = d.mean - half;
  d.high = d.mean + half;
  return d;
}

PairedDifference DifferenceOfShares(const std::vector<double>& before, const std::vector<double>& after) {
  CheckPairs("DifferenceOfShares", before, after);
  const PairCounts n = CountPairs(before, after);
  const auto share = [&](double count) {
    return WilsonInterval(static_cast<int>(count), static_cast<int>(before.size()));
  };
  const ShareInterval was = share(n.both + n.before), is = share(n.both + n.after);
  const double correlation = Correlation(n);
  const auto distance = [&](double of_one, double of_other) {
    return std::sqrt(std::max(0.0, of_one * of_one - 2.0 * correlation * of_one * of_other + of_other * of_other));
  };
  const double mean = is.share - was.share;
  return {.before = was.share,
          .after = is.share,
          .mean = mean,
          .low = std::max(-1.0, mean - distance(is.share - is.low, was.high - was.share)),
          .high = std::min(1.0, mean + distance(is.high - is.share, was.share - was.low))};
}

}  // namespace gaitwright
