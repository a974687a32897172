// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>

#include "playback/trials/orbit_stability_internal.h"

namespace gaitwright {
namespace {

/// What a largest magnitude means for deviations.
std::string PaceText(OrbitVerdict verdict, double largest) {
  switch (verdict) {
    case OrbitVerdict::kNeutral:
      return "some deviation, such as of place or heading, neither grows nor decays";
    case OrbitVerdict::kUnstable:
      return fmt::format("a deviation doubles in {:.1f} cycles", std::log(2.0) / std::log(largest));
    default:
      return largest > 0.5 ? fmt::format("deviations halve in {:.1f} cycles", std::log(0.5) / std::log(largest))
                           : "deviations more than halve in each cycle";
  }
}

}  // namespace

const char* OrbitVerdictName(OrbitVerdict verdict) {
  switch (verdict) {
    case OrbitVerdict::kUnknown:
      return "unknown";
    case OrbitVerdict::kStable:
      return "stable";
    case OrbitVerdict::kNeutral:
      return "neutral";
    case OrbitVerdict::kUnstable:
      return "unstable";
  }
  return "";
}

OrbitVerdict OrbitStability::verdict() const {
  constexpr double kNeutral = 0.05;
  if (!missing.empty()) return OrbitVerdict::kUnknown;
  if (std::abs(multipliers.largest() - 1.0) < kNeutral) return OrbitVerdict::kNeutral;
  return multipliers.largest() < 1.0 ? OrbitVerdict::kStable : OrbitVerdict::kUnstable;
}

std::string OrbitText(const OrbitStability& orbit) {
  if (orbit.verdict() == OrbitVerdict::kUnknown) return fmt::format("no Floquet multipliers: {}", orbit.missing);
  constexpr double kMuch = 0.5;
  const double largest = orbit.multipliers.largest();
  return fmt::format(
      "{}; largest Floquet multiplier {:.2f} over {} cycles of {:.3f} s, {:.0f} % of deviations unexplained{}; {}",
      OrbitVerdictName(orbit.verdict()), largest, orbit.cycles, orbit.cycle_s, 100.0 * orbit.multipliers.unexplained,
      orbit.multipliers.unexplained > kMuch ? ", so that the multipliers are rough" : "",
      PaceText(orbit.verdict(), largest));
}

}  // namespace gaitwright
