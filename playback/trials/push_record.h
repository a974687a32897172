// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "playback/trials/trial_outcome.h"

namespace gaitwright {

/// A fall within this time after the end of a push is attributed to the push, unless another push has begun [s].
inline constexpr double kPushWindow = 2.0;
/// The robot has recovered from a push if it stood this long after the push ended, before another push began or the
/// playback ended [s].
inline constexpr double kPushWatched = 1.0;

/// One push of one trial.
struct PushRecord {
  enum class Outcome {
    kRecovered,  ///< the robot stood for kPushWatched after it, and it did not cause a fall
    kFatal,      ///< the robot fell within kPushWindow, without another push in between
    kUnknown,    ///< the playback ended, or another push began, too early to decide
  };

  double forward_n = 0.0, left_n = 0.0, up_n = 0.0, at_s = 0.0, duration_s = 0.0;
  Outcome outcome = Outcome::kUnknown;

  /// Size of the whole force, including its vertical component [N].
  double size_n() const;
  /// Direction in plan view: 0 forward, 90 to the left; nothing for a vertical or zero push [deg].
  std::optional<double> direction_deg() const;

  bool operator==(const PushRecord&) const = default;
};

/// Pushes in a sector of directions.
struct PushBin {
  double direction_deg = 0.0;  ///< middle of the sector, relative to the planned heading: 0 forward, 90 left
  int n = 0, fell = 0;         ///< fatal and recovered pushes, and the fatal ones among them
  int unknown = 0;             ///< additional pushes with unknown outcome
  std::optional<double> largest_survived_n = {}, smallest_fatal_n = {};

  bool operator==(const PushBin&) const = default;
};

/// The sampled pushes of a trial in order of their beginning, without pushes of zero force and pushes after a fall.
/// @param other_s  start of a push that is not sampled, the same in each trial; later events are attributed to it.
std::vector<PushRecord> PushesOf(const TrialOutcome& outcome, std::optional<double> other_s = std::nullopt);

/// Pushes in eight directions, the first forward; empty without pushes.
std::vector<PushBin> PushBins(const std::vector<PushRecord>& pushes);

}  // namespace gaitwright
