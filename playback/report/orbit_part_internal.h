// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "playback/trials/orbit_stability_internal.h"

namespace gaitwright {

/// The part of a report page about the orbit stability of a gait: the verdict, the Floquet multipliers in the complex
/// plane with the unit circle, and a table of the largest ones.
std::string OrbitPart(const OrbitStability& orbit);

}  // namespace gaitwright
