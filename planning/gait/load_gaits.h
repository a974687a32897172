// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "planning/plan/gait.h"

namespace gaitwright {

/// A gait as its file has it, before it is fitted to a robot.
struct GaitEntry {
  Gait gait;                        ///< cycle_s is 0 when it scales with the leg
  double cycle_per_leg_time = 0.0;  ///< cycle over sqrt(leg length / g)
  double stride_per_leg = 0.0;      ///< largest stride if no speed is given, divided by the leg length; 0 for any
};

/// Reads and validates a file of gaits, see docs/gaits.md. Failure kBadInput with file and line for invalid YAML,
/// duplicate names and keys, unknown keys (the nearest is named), values of the wrong kind, numbers that are not
/// finite, not whole for counts of feet, or out of range, and lists whose length is not the number of feet.
Result<std::vector<GaitEntry>> LoadGaits(const std::string& path);

/// The gaits that come with the program.
Result<std::vector<GaitEntry>> BuiltInGaits();

/// The file that they stand in.
std::string BuiltInGaitsFile();

/// Gaits that are made for any number of feet: "wave" for three or more, the crawl's timing with each foot alone in the
/// air, from rear to front on the left and then on the right (from the last foot to the first when they are odd); and
/// "alternating" for an even number of six or more, two sets that are neighbours to each other. Feet stand in the
/// robot's order: front before rear, left before right.
std::vector<GaitEntry> GeneratedGaits(int num_feet);

}  // namespace gaitwright
