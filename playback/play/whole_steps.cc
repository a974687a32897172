// SPDX-License-Identifier: BSD-3-Clause
#include "playback/play/whole_steps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kinematics/base/result.h"

namespace gaitwright {

long WholeSteps(const std::string& key, double rate_hz, double step_s) {
  constexpr double kRounded = 1e-4;
  const double steps = 1.0 / (rate_hz * step_s), nearest = std::max(1.0, std::round(steps));
  if (std::abs(steps - nearest) <= kRounded * steps) return std::lround(nearest);
  throw InvalidArgument(fmt::format(
      "option '{}' is {} Hz, which does not divide the {:.6g} steps per second; the nearest accepted value is {:.6g}",
      key, rate_hz, 1.0 / step_s, 1.0 / (step_s * nearest)));
}

}  // namespace gaitwright
