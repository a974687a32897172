// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// Limits of the leg motors at a height, with level base, flat feet at their standing positions, and all other joints
/// as in standing.
struct PushOff {
  VectorX q;               ///< the posture; its centre of mass over the place that it is over in standing
  double com_m = 0.0;      ///< height of the centre of mass over the ground
  double speed_m_s = 0.0;  ///< the fastest that it rises while the feet stand
  double gain_m_s2 = 0.0;  ///< largest upward acceleration; below 0 if the weight cannot be held
  int fastest = -1;        ///< the motor (ActuatorOf) that limits the speed; -1 if none does
  int strongest = -1;      ///< the motor that limits the acceleration
};

/// Postures by height, from straight legs down to the lowest in which joints keep `reserve` of their range to their
/// ends, at even steps of 1 % of the leg; that of standing is among them.
/// @param pushing  how many feet push at a time; each is taken to carry its share from under the centre of mass, with
///                 motors at `use` of what they give.
std::vector<PushOff> PushOffs(const RobotModel& model, int pushing, double reserve, double use);

/// Upward acceleration of feet that are in the air together, at standing, with all the torque that motors give, while
/// the body falls freely and turns against them [m/s^2].
/// @param feet  those that move; the others stay with the body.
double FootAccelerationInFlight(const RobotModel& model, const std::vector<int>& feet);

}  // namespace gaitwright
