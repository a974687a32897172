// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/model/robot_model.h"
#include "optimisation/centroidal/rigid_body_problem.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// Limits of the leg motors at a height, with level base, flat feet at their standing positions, and all other joints
/// as in standing.
struct PushOff {
  VectorX q;               ///< the posture, with the centre of mass above the same point as in standing
  double com_m = 0.0;      ///< height of the centre of mass above the ground
  double speed_m_s = 0.0;  ///< largest rising speed with the feet on the ground
  double gain_m_s2 = 0.0;  ///< largest upward acceleration; below 0 if the weight cannot be held
  int fastest = -1;        ///< the motor (ActuatorOf) that limits the speed; -1 if none does
  int strongest = -1;      ///< the motor that limits the acceleration
  /// By motor: effort at rest, effort by upward acceleration, and speed by rising speed.
  VectorX effort_at_rest, effort_by_gain, speed_by_rise;
};

/// Postures by height, from straight legs down to the lowest one in which joints keep `reserve` of their range to their
/// ends, in steps of 1 % of the leg length; standing is one of them.
/// @param pushing  number of feet that push at a time; each carries its share below the centre of mass, with motors at
///                 the share `use` of their limits.
std::vector<PushOff> PushOffs(const RobotModel& model, int pushing, double reserve, double use);

/// Largest upward acceleration in a posture at a rising speed, with motors at the share `use` of their torque-speed
/// curves [m/s^2]. A motor without a curve has its effort limit at any speed.
double GainAtSpeed(const RobotModel& model, const PushOff& at, double rising_m_s, double use);

/// Upward acceleration of feet that are in the air together, in the standing posture, with full motor torque, while the
/// body falls freely and reacts by rotation [m/s^2].
/// @param feet  moving feet; the others are fixed to the body.
double FootAccelerationInFlight(const RobotModel& model, const std::vector<int>& feet);

/// Forces on a foot that its leg's motors can hold in the posture of a row: all but what they need for the motion.
MotorLimits MotorLimitsOf(const RobotModel& model, const WholeBodyTrajectory& rows, std::size_t row, int foot,
                          DynamicsScratch& scratch);

}  // namespace gaitwright
