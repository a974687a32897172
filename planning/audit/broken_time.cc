// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "planning/audit/broken_time_internal.h"

namespace gaitwright {

std::string ShareText(double share) {
  return 100.0 * share < 0.1 ? "under 0.1 %" : fmt::format("{:.1f} %", 100.0 * share);
}

std::string WorstSecondsText(const BrokenTime& broken) {
  std::string text;
  for (const double start_s : broken.worst_s)
    text += fmt::format("{}{:.0f} to {:.0f} s", text.empty() ? "" : ", ", start_s, start_s + 1.0);
  return text;
}

std::string BrokenText(const std::vector<BrokenTime>& broken) {
  std::string text;
  for (const BrokenTime& one : broken) {
    text += fmt::format("  {:<18} fails in {} of the time, longest from {}\n", LawName(one.law), ShareText(one.share),
                        WorstSecondsText(one));
  }
  return text;
}

std::string BrokenJson(const std::vector<BrokenTime>& broken) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const BrokenTime& one : broken)
    list.push_back({{"law", LawName(one.law)}, {"share", one.share}, {"worst_s", one.worst_s}});
  return list.dump(2);
}

}  // namespace gaitwright
