// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "kinematics/model/robot_model.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// How much of their limits the motors use in torque, over all motors with a limit.
struct TorqueUse {
  double rms = 0.0;   ///< root of the mean square over time and motors
  double peak = 0.0;  ///< the greatest share
};
/// @return the use of the motors over all samples of the motion.
TorqueUse TorqueUseOf(const RobotModel& model, const WholeBodyTrajectory& motion);

/// What of the motion of a rigid body says whether it is better than another one.
struct MotionFigures {
  double limit_excess = 0.0;  ///< past limits of joints and motors, summed in shares of the limits
  double residual = 0.0;      ///< what contacts do not give over m g [1], [m]
  TorqueUse torque;
};

/// Whether a motion is better than a former one, none where there is no former one: it keeps the limits, or breaks them
/// by less, where the former one breaks them; or its contacts balance it where those of the former one do not; or the
/// product of both figures of TorqueUse is less by 1 % or more.
/// @param residual  that the passes were to come to.
bool IsBetterMotion(const MotionFigures& motion, const std::optional<MotionFigures>& former, double residual);

}  // namespace gaitwright
