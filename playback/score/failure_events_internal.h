// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "playback/score/why_it_fell.h"

namespace gaitwright {

using Event = std::optional<FailureEvent>;

inline constexpr double kPersistent = 0.05;  // a state that lasts this long is no transient [s]

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

/// Index of the first sample from which `holds` is true for kPersistent, or to the end if that comes sooner.
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

// What is wrong with the plan itself (plan_faults.cc); each tells when first, and how much at worst before the fall.

/// ZMP outside of its support: beyond 2 mm where that has area, 5 mm where it is a line, on which the low-passed ZMP
/// comes late at each change of support.
Event PlanUnstable(const ScoreInputs& in);

/// A joint past its limit of position or torque.
Event PlanBeyondLimits(const ScoreInputs& in);

/// Contact forces outside of the friction cone of the plan's own ground.
Event PlanBeyondFriction(const ScoreInputs& in);

/// Torques or the sum of contact forces other than inverse dynamics has them: by 5 % of m g, or of m g over the leg.
/// Nothing for a plan without forces.
Event PlanForcesOff(const ScoreInputs& in);

}  // namespace gaitwright
