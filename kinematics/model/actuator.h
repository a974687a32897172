// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// A motor of the robot with its speed and effort limits. These limits are stored nowhere else. Most motors drive one
/// joint; the motors of a Transmission drive several joints together. A robot has as many motors as independent
/// coordinates, so vectors by motor and vectors by coordinate have the same size. Motor d drives coordinate d alone, or
/// it is a motor of the transmission of d: if d is joint k of the transmission, motor d is its motor k.
///
/// The limits are those of the motor, not of a joint of a transmission:
///   |Effort(tau)| <= effort_limit,   |Speed(v)| <= velocity_limit.
struct Actuator {
  /// Share of one joint in the sums speed = sum of by_speed * v[dof] and effort = sum of by_effort * tau[dof].
  struct Term {
    int dof;
    double by_speed;   ///< element of R
    double by_effort;  ///< element of R^-T
  };

  std::string name;                      ///< the joint's name for the motor of one joint
  std::vector<Term> terms;               ///< one for a motor of one joint
  double effort_limit = Motor::kNone;    ///< [N m] or [N]; infinite if unknown
  double velocity_limit = Motor::kNone;  ///< [rad/s] or [m/s]; infinite if unknown
  bool slides = false;
  Motor motor;
  int transmission = -1;  ///< index into RobotModel::transmissions; -1 for the motor of one joint

  bool shared() const { return transmission >= 0; }
  /// Speed and effort of the motor from the speeds and torques of all joints, size num_dofs.
  double Speed(const Eigen::Ref<const VectorX>& v) const;
  double Effort(const Eigen::Ref<const VectorX>& tau) const;

  const char* speed_unit() const { return slides ? "m/s" : "rad/s"; }
  const char* effort_unit() const { return slides ? "N" : "N m"; }
};

/// Motor `index` of a robot, and all of them, size num_dofs.
Actuator ActuatorOf(const RobotModel& model, int index);
std::vector<Actuator> ActuatorsOf(const RobotModel& model);

/// Index of a motor and the used share of its limit, 1 at the limit; -1 and 0 if no limit is known.
struct LargestUse {
  int motor = -1;
  double share = 0.0;
};
/// The motor that torques of the joints bring nearest to its effort limit.
LargestUse LargestEffortUse(const RobotModel& model, const VectorX& tau);
/// The motor that speeds of the joints bring nearest to its speed limit.
LargestUse LargestSpeedUse(const RobotModel& model, const VectorX& v);

/// Joint torques with each motor's effort limited: R^T clamp(R^-T tau). If a motor of a transmission is at its limit,
/// the torques of all its joints change. ClampedSpeeds limits speeds in the same way: R^-1 clamp(R v).
VectorX ClampedEfforts(const RobotModel& model, const VectorX& tau);
VectorX ClampedSpeeds(const RobotModel& model, const VectorX& v);

}  // namespace gaitwright
