// SPDX-License-Identifier: BSD-3-Clause
#include "playback/trials/push_record.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace gaitwright {
namespace {

constexpr int kDirections = 8;

/// All sampled pushes, in order of their beginning.
std::vector<PushRecord> SampledPushes(const TrialOutcome& outcome) {
  std::vector<PushRecord> pushes;
  std::string name;
  for (const SampledValue& one : outcome.sampled) {
    const std::size_t dot = one.name.find('.');
    if (!one.name.starts_with("push") || dot == std::string::npos) continue;
    if (one.name.substr(0, dot) != name) pushes.emplace_back();
    name = one.name.substr(0, dot);
    const std::string part = one.name.substr(dot + 1);
    if (part == "ahead_n") pushes.back().forward_n = one.value;
    if (part == "left_n") pushes.back().left_n = one.value;
    if (part == "up_n") pushes.back().up_n = one.value;
    if (part == "at_s") pushes.back().at_s = one.value;
    if (part == "duration_s") pushes.back().duration_s = one.value;
  }
  std::stable_sort(pushes.begin(), pushes.end(), [](const auto& a, const auto& b) { return a.at_s < b.at_s; });
  return pushes;
}

/// @param until_s  start of the next push, or end of the playback. @param last  no other push follows before that end.
PushRecord::Outcome Judged(const PushRecord& push, double until_s, bool last, bool survived) {
  const double watched = until_s - (push.at_s + push.duration_s);
  if (last && !survived && watched <= kPushWindow) return PushRecord::Outcome::kFatal;
  return watched >= kPushWatched ? PushRecord::Outcome::kRecovered : PushRecord::Outcome::kUnknown;
}

}  // namespace

double PushRecord::size_n() const { return std::hypot(forward_n, left_n, up_n); }

std::optional<double> PushRecord::direction_deg() const {
  constexpr double kLeastShare = 1e-6;  // share of the force above which it is not rounding
  if (std::hypot(forward_n, left_n) <= kLeastShare * size_n()) return std::nullopt;
  return std::atan2(left_n, forward_n) * 180.0 / std::numbers::pi;
}

std::vector<PushRecord> PushesOf(const TrialOutcome& outcome, std::optional<double> other_s) {
  std::vector<PushRecord> pushes = SampledPushes(outcome);
  std::erase_if(pushes, [&](const PushRecord& p) { return p.at_s > outcome.ended_s || p.size_n() == 0.0; });
  for (std::size_t i = 0; i < pushes.size(); ++i) {
    double until_s = i + 1 < pushes.size() ? pushes[i + 1].at_s : outcome.ended_s;
    bool last = i + 1 == pushes.size();
    if (other_s && *other_s >= pushes[i].at_s && *other_s < until_s) {
      until_s = *other_s;
      last = false;
    }
    pushes[i].outcome = Judged(pushes[i], until_s, last, outcome.survived);
  }
  return pushes;
}

std::vector<PushBin> PushBins(const std::vector<PushRecord>& pushes) {
  constexpr double kWidth = 360.0 / kDirections;
  std::vector<PushBin> bins;
  for (int i = 0; i < kDirections && !pushes.empty(); ++i) bins.push_back({.direction_deg = kWidth * i});
  for (const PushRecord& push : pushes) {
    const std::optional<double> direction = push.direction_deg();
    if (!direction) continue;
    const auto i = (static_cast<int>(std::lround(*direction / kWidth)) + kDirections) % kDirections;
    PushBin& bin = bins[static_cast<std::size_t>(i)];
    const double size = push.size_n();
    if (push.outcome == PushRecord::Outcome::kUnknown) {
      ++bin.unknown;
      continue;
    }
    const bool fatal = push.outcome == PushRecord::Outcome::kFatal;
    ++bin.n;
    bin.fell += fatal ? 1 : 0;
    if (fatal) bin.smallest_fatal_n = std::min(bin.smallest_fatal_n.value_or(size), size);
    if (!fatal) bin.largest_survived_n = std::max(bin.largest_survived_n.value_or(size), size);
  }
  return bins;
}

}  // namespace gaitwright
