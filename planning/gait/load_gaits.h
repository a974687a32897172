// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "planning/plan/gait.h"

namespace gaitwright {

/// A gait as read from its file, before it is fitted to a robot.
struct GaitEntry {
  Gait gait;                        ///< cycle_s is 0 when it scales with the leg
  double cycle_per_leg_time = 0.0;  ///< cycle divided by sqrt(leg length / g)
  double stride_per_leg = 0.0;      ///< largest stride / leg length without a given speed; 0 is unlimited
  double shortest_cycle = 0.5;      ///< shortest cycle for speed / cycle
  /// Forward and lateral travel in each cycle / leg length, of a gait with travel of its own.
  std::optional<std::array<double, 2>> travel_per_leg = {};
};

/// Reads and validates a file of gaits, see docs/gaits.md. Failure kBadInput, with file and line, for: invalid YAML;
/// duplicate names and keys; unknown keys (the message names the nearest one); values of the wrong kind; numbers that
/// are not finite or out of range; numbers of feet that are not whole; lists whose length differs from the number of
/// feet.
Result<std::vector<GaitEntry>> LoadGaits(const std::string& path);

/// The gaits that are installed with the program.
Result<std::vector<GaitEntry>> BuiltInGaits();

/// The file of BuiltInGaits().
std::string BuiltInGaitsFile();

/// Gaits that are generated for any number of feet, in the robot's order of feet (front before rear, left before
/// right):
/// "wave" for three or more feet: the timing of the crawl, with one foot at a time in the air. Feet lift from rear to
/// front, first on the left, then on the right; for an odd number, from the last foot to the first.
/// "alternating" for an even number of six or more feet: two sets of feet, so that neighbours are in different sets.
std::vector<GaitEntry> GeneratedGaits(int num_feet);

}  // namespace gaitwright
