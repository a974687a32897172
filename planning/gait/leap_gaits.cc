// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <functional>
#include <vector>

#include "planning/gait/leap_gaits_internal.h"
#include "planning/gait/load_gaits.h"

namespace gaitwright {

std::string LeapGait(int num_feet) {
  std::string leap;
  double stride = -1.0;
  const std::vector<GaitEntry> gaits = BuiltInGaits().value();
  for (const GaitEntry& entry : gaits) {
    const Gait& gait = entry.gait;
    const bool at_once =
        std::adjacent_find(gait.phase.begin(), gait.phase.end(), std::not_equal_to<>()) == gait.phase.end();
    if (gait.num_feet() != num_feet || num_feet < 2 || !at_once || !HasFlight(gait) || TurnsOver(gait)) continue;
    if (entry.stride_per_leg <= stride) continue;
    stride = entry.stride_per_leg;
    leap = gait.name;
  }
  return leap;
}

std::string GaitTurningOver(int num_feet, const std::string& direction) {
  const std::vector<GaitEntry> gaits = BuiltInGaits().value();
  for (const GaitEntry& entry : gaits) {
    const Gait& gait = entry.gait;
    if (gait.num_feet() != num_feet) continue;
    const bool is_it =
        (direction == "forward" && gait.pitch_turns > 0.0) || (direction == "backward" && gait.pitch_turns < 0.0) ||
        (direction == "right" && gait.roll_turns > 0.0) || (direction == "left" && gait.roll_turns < 0.0);
    if (is_it) return gait.name;
  }
  return "";
}

}  // namespace gaitwright
