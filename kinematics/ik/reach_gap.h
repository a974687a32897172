// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace gaitwright {

/// Distance of a foot's target from the leg's geometric reach, without joint limits.
struct ReachGap {
  enum class Kind {
    kNone,         ///< within reach
    kTooFar,       ///< farther from the hip than the straight leg
    kTooNear,      ///< nearer to the hip than the folded leg
    kTooNearAxis,  ///< nearer to the axis of the first joint than the foot's offset from it
    kTurned,       ///< the position is within reach, but the rotation is not
  };
  Kind kind = Kind::kNone;
  double distance_m = 0.0;  ///< from the target to the nearest point within reach, with the same rotation
  double angle_rad = 0.0;   ///< smallest error of the foot's rotation
};

}  // namespace gaitwright
