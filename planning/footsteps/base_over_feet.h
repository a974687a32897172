// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/model/robot_model.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// Where the base is carried over feet that stand anywhere.
struct BaseOverFeet {
  PlanarPose plan;                         ///< x, y and yaw of the base
  double ground_m = 0.0;                   ///< height of the plane through the feet under the base's origin [m]
  double roll_rad = 0.0, pitch_rad = 0.0;  ///< of that plane in the base's heading; R = Rz(yaw) Ry(pitch) Rx(roll)
};

/// The base over its feet: in plan view where the feet's places in the standing posture fit best to where they are
/// (least squares over rotation and translation: Umeyama, TPAMI 13(4), 1991), tilted like the plane that fits best
/// through them. A tilt that the feet do not determine, such as the pitch over two feet side by side, is zero.
/// @param standing  contact frames by foot, X_BF, as StandingFeet gives them.
/// @param X_WF      present contact frames, by foot.
BaseOverFeet FitBase(const std::vector<Pose>& standing, const std::vector<Pose>& X_WF);

/// As above, with a given heading. Allocates nothing.
BaseOverFeet FitBase(const std::vector<Pose>& standing, const std::vector<Pose>& X_WF, double yaw_rad);

/// Mean yaw of the feet relative to the standing posture. For a base whose feet step one after the other, the feet's
/// positions alone would turn the base to and fro with every step.
double MeanHeading(const std::vector<Pose>& standing, const std::vector<Pose>& X_WF);

}  // namespace gaitwright
