// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace gaitwright {

/// Name of the built-in gait in which all feet leap at once, from all feet onto all feet, without turning over; a gait
/// with a default stride is preferred. Empty if this number of feet has no such gait.
std::string LeapGait(int num_feet);

/// Name of the built-in gait in which the body turns over in a direction: "forward" and "backward" about its y axis,
/// "left" and "right" about its x axis. Empty if this number of feet has no such gait.
std::string GaitTurningOver(int num_feet, const std::string& direction);

}  // namespace gaitwright
