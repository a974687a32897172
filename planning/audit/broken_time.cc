// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "planning/audit/broken_time_internal.h"

namespace gaitwright {
namespace {

/// A share of time in per cent; never 0 for what happens at all.
std::string ShareText(double share) {
  return 100.0 * share < 0.1 ? "under 0.1 %" : fmt::format("{:.1f} %", 100.0 * share);
}

}  // namespace

std::string BrokenText(const std::vector<BrokenTime>& broken) {
  std::string text;
  for (const BrokenTime& one : broken) {
    std::vector<std::string> seconds;
    for (const double start_s : one.worst_s)
      seconds.push_back(fmt::format("{:.0f} to {:.0f} s", start_s, start_s + 1.0));
    text += fmt::format("  {:<18} fails in {} of the time, longest from {}\n", LawName(one.law), ShareText(one.share),
                        fmt::join(seconds, ", "));
  }
  return text;
}

}  // namespace gaitwright
