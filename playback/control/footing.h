// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// Measured places of the feet relative to their plan, from the standing feet.
struct Footing {
  std::vector<Vector3> offset_W;            ///< by foot: contact point less its planned place [m]
  Vector3 ground_tilt_W = Vector3::Zero();  ///< rotation vector of the ground relative to the plan's
  Vector3 mean_offset_W = Vector3::Zero();  ///< of the feet that should stand [m]
};

}  // namespace gaitwright
