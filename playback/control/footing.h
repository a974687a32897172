// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// Where the feet are against their plan, as those that stand tell.
struct Footing {
  std::vector<Vector3> offset_W;            ///< by foot: contact point less its planned place [m]
  Vector3 ground_tilt_W = Vector3::Zero();  ///< rotation vector of the ground against the plan's
  Vector3 mean_offset_W = Vector3::Zero();  ///< of the feet that shall stand [m]
  Vector3 middle_W = Vector3::Zero();       ///< of their planned places [m]
};

}  // namespace gaitwright
