// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/model/robot_model.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// Pose of the base above feet at any places.
struct BaseOverFeet {
  PlanarPose plan;                         ///< x, y and yaw of the base
  double ground_m = 0.0;                   ///< height of the plane through the feet under the base's origin [m]
  double roll_rad = 0.0, pitch_rad = 0.0;  ///< of that plane in the base's heading; R = Rz(yaw) Ry(pitch) Rx(roll)
};

/// The pose of the base that fits its feet. In plan view, the standing places of the feet fit best to their present
/// places (least squares over rotation and translation: Umeyama, TPAMI 13(4), 1991). The base is tilted like the
/// best-fit plane through the feet. A tilt that the feet do not determine, such as the pitch above two feet side by
/// side, is zero.
/// @param standing  contact frames by foot, X_BF, from StandingFeet.
/// @param X_WF      present contact frames, by foot.
BaseOverFeet FitBase(const std::vector<Pose>& standing, const std::vector<Pose>& X_WF);

/// FitBase with a given heading. Does not allocate.
BaseOverFeet FitBase(const std::vector<Pose>& standing, const std::vector<Pose>& X_WF, double yaw_rad);

/// Mean yaw of the feet relative to the standing posture. If feet step one after the other, a heading computed from
/// their positions alone would oscillate with every step.
double MeanHeading(const std::vector<Pose>& standing, const std::vector<Pose>& X_WF);

}  // namespace gaitwright
