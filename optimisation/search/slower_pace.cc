// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/search/slower_pace.h"

#include <fmt/format.h>

#include <cmath>

namespace gaitwright {

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
    case Known::kFeasible:
      return fmt::format("a {} of {} is feasible with gait '{}'", name, amount, gait);
    case Known::kMay:
      return fmt::format("a {} of about {} may be feasible with gait '{}'", name, amount, gait);
  }
  return "";
}

}  // namespace gaitwright
