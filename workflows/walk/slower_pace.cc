// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/walk/slower_pace.h"

#include <fmt/format.h>

#include <cmath>

namespace gaitwright {

std::string PaceName(Pace pace) {
  switch (pace) {
    case Pace::kSpeed:
      return "speed";
    case Pace::kLateralSpeed:
      return "lateral speed";
    case Pace::kYawRate:
      return "turning rate";
    case Pace::kStepLength:
      return "step length";
  }
  return "";
}

std::string PaceText(const WalkCommand& command) {
  switch (PaceOf(command)) {
    case Pace::kSpeed:
      return fmt::format("{:.2g} m/s", command.speed_m_s);
    case Pace::kLateralSpeed:
      return fmt::format("{:.2g} m/s", std::abs(command.lateral_speed_m_s));
    case Pace::kYawRate:
      return fmt::format("{:.2g} rad/s", std::abs(command.yaw_rate_rad_s));
    case Pace::kStepLength:
      return fmt::format("{:.2g} m", std::abs(command.step_length_m));
  }
  return "";
}

std::string SlowerPace::Text(const WalkCommand& at_pace, const std::string& gait) const {
  const std::string name = PaceName(PaceOf(at_pace)), amount = PaceText(at_pace);
  switch (known) {
    case Known::kLargest:
      return fmt::format("the largest {} with gait '{}' is {}", name, gait, amount);
    case Known::kServes:
      return fmt::format("a {} of {} serves with gait '{}'", name, amount, gait);
    case Known::kMay:
      return fmt::format("a {} of about {} may serve with gait '{}'", name, amount, gait);
  }
  return "";
}

}  // namespace gaitwright
