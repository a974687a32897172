// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/search/slower_pace.h"

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

std::string PaceFlag(Pace pace) {
  switch (pace) {
    case Pace::kSpeed:
      return "speed";
    case Pace::kLateralSpeed:
      return "lateral-speed";
    case Pace::kYawRate:
      return "yaw-rate";
    case Pace::kStepLength:
      return "step-length";
  }
  return "";
}

std::string PaceUnit(Pace pace) { return pace == Pace::kYawRate ? "rad/s" : pace == Pace::kStepLength ? "m" : "m/s"; }

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

Suggestion SlowerPace::AsSuggestion(const WalkCommand& at_pace) const {
  const Pace pace = PaceOf(at_pace);
  const double signed_value = pace == Pace::kSpeed          ? at_pace.speed_m_s
                              : pace == Pace::kLateralSpeed ? at_pace.lateral_speed_m_s
                              : pace == Pace::kYawRate      ? at_pace.yaw_rate_rad_s
                                                            : at_pace.step_length_m;
  return {PaceFlag(pace), signed_value, known == Known::kMay ? Certainty::kEstimated : Certainty::kPlanned,
          PaceFlags(at_pace)};
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
