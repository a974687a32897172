// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "playback/trials/trial_outcome.h"

namespace gaitwright {

/// A fall that comes within this time after a push has ended is laid at its door, unless another push has begun [s].
inline constexpr double kPushWindow = 2.0;
/// A push counts as recovered from when the robot stood this long after its end, before another one began or the
/// playback ended [s].
inline constexpr double kPushWatched = 1.0;

/// One push of one trial.
struct PushRecord {
  enum class Outcome {
    kRecovered,  ///< the robot stood for kPushWatched after it, and did not fall by it
    kFatal,      ///< it fell within kPushWindow, and no other push came in between
    kUnknown,    ///< the playback ended, or another push came, too early to tell
  };

  double ahead_n = 0.0, left_n = 0.0, up_n = 0.0, at_s = 0.0, duration_s = 0.0;
  Outcome outcome = Outcome::kUnknown;

  /// Of the whole force, with its part upward [N].
  double size_n() const;
  /// Direction in plan view: 0 forward, 90 to the left; nothing for a vertical or zero push [deg].
  std::optional<double> direction_deg() const;

  bool operator==(const PushRecord&) const = default;
};

/// Pushes to about one direction.
struct PushBin {
  double direction_deg = 0.0;  ///< of its middle; 0 ahead, 90 to the left, as the planned base headed
  int n = 0, fell = 0;         ///< pushes that are fatal or recovered from, and those of them that are fatal
  int unknown = 0;             ///< additional pushes with unknown outcome
  std::optional<double> largest_survived_n = {}, smallest_fatal_n = {};

  bool operator==(const PushBin&) const = default;
};

/// The sampled pushes of a trial in the order of their beginning; those without force, or after a fall, are left out.
/// @param other_s  when a push that was not sampled begins, the same in each trial: what comes after it is its.
std::vector<PushRecord> PushesOf(const TrialOutcome& outcome, std::optional<double> other_s = std::nullopt);

/// Pushes by eight directions, the first ahead; empty where nothing pushes.
std::vector<PushBin> PushBins(const std::vector<PushRecord>& pushes);

}  // namespace gaitwright
