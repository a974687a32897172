// SPDX-License-Identifier: BSD-3-Clause
#include "planning/audit/findings.h"

#include <algorithm>
#include <cmath>

namespace gaitwright {
namespace {

/// Value that is compared between the places of one check: the share of the limit if there is one, otherwise the
/// margin.
double MarginOf(const AuditMargin& margin) { return margin.share ? *margin.share : margin.margin; }

/// Checks whose limits are sizes from zero up, so that a share of the limit is meaningful.
bool IsOfSize(Law law) {
  return law != Law::kJointPosition && law != Law::kZmpSupport && law != Law::kUnilateral &&
         law != Law::kFootClearance && law != Law::kBodyClearance && law != Law::kSelfCollision;
}

}  // namespace

int Findings::Place(Law law, const std::string& where, const std::string& unit) {
  places_.emplace_back();
  names_.push_back({law, where, unit});
  return static_cast<int>(names_.size()) - 1;
}

void Findings::Break(int place, double at_s, double value, double limit) {
  const Named& named = names_[static_cast<std::size_t>(place)];
  Note(named.law, named.where, at_s, value, limit, named.unit.c_str());
}

void Findings::Note(Law law, const std::string& where, double at_s, double value, double limit, const char* unit) {
  Count(law, at_s);
  // A value that is not finite is a violation, too.
  const double violation = std::isfinite(value) ? std::abs(value - limit) : 1e300;
  const auto [entry, is_first] = worst_.try_emplace({law, where});
  if (is_first || violation > entry->second.first) entry->second = {violation, {law, at_s, where, value, limit, unit}};
}

void Findings::Count(Law law, double at_s) {
  if (samples_ <= 0) return;
  std::vector<bool>& fails = fails_[law];
  if (fails.empty()) fails.assign(static_cast<std::size_t>(samples_), false);
  const double sample = std::round((at_s - start_s_) * rate_hz_);
  fails[static_cast<std::size_t>(sample > 0.0 ? std::min(sample, samples_ - 1.0) : 0.0)] = true;
}

std::vector<BrokenTime> Findings::Broken() const {
  constexpr std::size_t kMost = 3;  // seconds
  std::vector<BrokenTime> sorted;
  for (const Law law : AllLaws()) {
    const auto found = fails_.find(law);
    if (found == fails_.end()) continue;
    BrokenTime broken{law, 0.0, {}, {}};
    int failing = 0;
    std::map<double, int> by_second;
    for (std::size_t k = 0; k < found->second.size(); ++k) {
      if (!found->second[k]) continue;
      const double at_s = start_s_ + static_cast<double>(k) / rate_hz_;
      ++failing;
      ++by_second[std::floor(at_s + 1e-9)];
      if (k == 0 || !found->second[k - 1]) broken.spans.push_back({at_s, at_s});
      broken.spans.back().end_s = at_s + 1.0 / rate_hz_;
    }
    broken.share = static_cast<double>(failing) / samples_;
    std::vector<std::pair<double, int>> seconds(by_second.begin(), by_second.end());
    std::stable_sort(seconds.begin(), seconds.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
    if (seconds.size() > kMost) seconds.resize(kMost);
    for (const auto& second : seconds) broken.worst_s.push_back(second.first);
    sorted.push_back(std::move(broken));
  }
  return sorted;
}

std::vector<Violation> Findings::Sorted() const {
  std::vector<Violation> sorted;
  for (const Law law : AllLaws()) {
    std::vector<std::pair<double, Violation>> of_law;
    for (const auto& [key, entry] : worst_) {
      if (key.first == law) of_law.push_back(entry);
    }
    std::stable_sort(of_law.begin(), of_law.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    for (const auto& entry : of_law) sorted.push_back(entry.second);
  }
  return sorted;
}

std::vector<AuditMargin> Findings::Margins() const {
  std::vector<AuditMargin> sorted;
  for (const Law law : AllLaws()) {
    std::vector<AuditMargin> of_law;
    for (std::size_t i = 0; i < names_.size(); ++i) {
      const Closest& closest = places_[i];
      if (names_[i].law != law || !std::isfinite(closest.limit) || closest.room >= 1e300) continue;
      AuditMargin margin = {law,          closest.at_s, names_[i].where, closest.value, closest.limit,
                            closest.room, {},           names_[i].unit};
      if (IsOfSize(law) && closest.limit > 0.0) margin.share = closest.room / closest.limit;
      of_law.push_back(margin);
    }
    std::stable_sort(of_law.begin(), of_law.end(),
                     [](const AuditMargin& a, const AuditMargin& b) { return MarginOf(a) < MarginOf(b); });
    sorted.insert(sorted.end(), of_law.begin(), of_law.end());
  }
  return sorted;
}

}  // namespace gaitwright
