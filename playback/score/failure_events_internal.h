// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "playback/score/reason_of_fall.h"

namespace gaitwright {

using Event = std::optional<FailureEvent>;

inline constexpr double kPersistent = 0.05;  // a state that lasts this long is not a transient [s]

inline const std::string& FootName(const ScoreInputs& in, int foot) {
  return in.model.feet[static_cast<std::size_t>(foot)].name;
}

inline std::string NamesOf(const ScoreInputs& in, FootSet stance) {
  std::string names;
  for (int foot = 0; foot < static_cast<int>(in.model.feet.size()); ++foot) {
    if (Contains(stance, foot)) names += (names.empty() ? "'" : ", '") + FootName(in, foot) + "'";
  }
  return names;
}

/// Index of the first sample from which `holds` is true for kPersistent, or to the end if the end comes first.
template <class Holds>
std::optional<std::size_t> FirstPersistent(const std::vector<MotionSample>& samples, Holds holds) {
  std::optional<std::size_t> start;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    if (!holds(k)) {
      start.reset();
    } else if (!start) {
      start = k;
    }
    if (start && samples[k].time_s - samples[*start].time_s >= kPersistent) return start;
  }
  return start;
}

// Faults of the plan itself (plan_faults.cc). Each event gives the time of the first fault and the worst value before
// the fall.

/// ZMP outside its support: beyond 2 mm if the support has area. On a line beyond 5 mm, because the low-passed ZMP lags
/// at each change of support.
Event PlanUnstable(const ScoreInputs& in);

/// A joint beyond a position or torque limit.
Event PlanBeyondLimits(const ScoreInputs& in);

/// Contact forces outside the friction cone of the plan's own ground.
Event PlanBeyondFriction(const ScoreInputs& in);

/// Torques or the sum of contact forces that differ from inverse dynamics by 5 % of m g, or of m g times the leg
/// length. Nothing for a plan without forces.
Event PlanForcesOff(const ScoreInputs& in);

}  // namespace gaitwright
