// SPDX-License-Identifier: BSD-3-Clause
#include "planning/plan/adjustment.h"

#include <fmt/format.h>

#include <map>

namespace gaitwright {

std::string AdjustmentText(const Adjustment& adjustment) {
  static const std::map<std::string, std::string> names = {
      {"speed", "speed"},           {"lateral-speed", "lateral speed"},
      {"yaw-rate", "turning rate"}, {"step-length", "step length"},
      {"gait.cycle_s", "cycle"},    {"gait.duty_factor", "duty factor"}};
  const auto known = names.find(adjustment.what);
  const std::string unit = adjustment.unit == "1" ? "" : " " + adjustment.unit;
  const std::string why = adjustment.why == FailureCode::kTorque
                              ? "which needs more torque"
                              : fmt::format("which fails with '{}'", FailureCodeName(adjustment.why));
  return fmt::format("a {} of {:.3g}{} instead of {:.3g}{}, {}{}",
                     known == names.end() ? adjustment.what : known->second, adjustment.given, unit, adjustment.asked,
                     unit, why, adjustment.part.empty() ? "" : fmt::format(" (part {})", adjustment.part));
}

}  // namespace gaitwright
