// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "kinematics/model/robot_model.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// Use of the motors' torque limits, over all motors with a limit.
struct TorqueUse {
  double rms = 0.0;   ///< root mean square over time and motors
  double peak = 0.0;  ///< largest share of a limit
};
/// @return the torque use over all samples of the motion.
TorqueUse TorqueUseOf(const RobotModel& model, const WholeBodyTrajectory& motion);

/// Figures for the comparison of two motions of a rigid body.
struct MotionFigures {
  double limit_violation = 0.0;  ///< violation of joint and motor limits, summed in shares of the limits
  double residual = 0.0;         ///< unbalanced force / (m g) [1] or moment / (m g) [m]
  TorqueUse torque;
};

/// Whether a motion is better than the former one (always true without a former one): it has a smaller limit violation,
/// if the former motion violates limits; or it is balanced by its contacts and the former motion is not; or the product
/// of both figures of TorqueUse is smaller by at least 1 %.
/// @param residual  target residual of a finished motion.
bool IsBetterMotion(const MotionFigures& motion, const std::optional<MotionFigures>& former, double residual);

}  // namespace gaitwright
