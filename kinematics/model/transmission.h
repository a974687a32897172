// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/model/motor.h"
#include "kinematics/spatial/pose.h"

namespace gaitwright {

struct RobotModel;

/// One of the motors of a transmission. All its values are those of the motor, not of a joint.
struct TransmissionMotor {
  std::string name;
  double effort_limit = Motor::kNone;    ///< [N m]; infinite if unknown
  double velocity_limit = Motor::kNone;  ///< [rad/s]; infinite if unknown
  bool slides = false;                   ///< a linear motor, with units N, m/s and kg
  Motor motor = {};                      ///< curve, thermal limit and rotor; joints have acceleration and jerk limits
};

/// Motors that drive several joints together, such as the two motors that move pitch and roll of an ankle by rods.
/// Let v and tau be the speeds and torques of its joints, w and m those of its motors, and R a constant matrix:
///   w = R v,   tau = R^T m,   so that   m^T w = tau^T v,   v = R^-1 w,   m = R^-T tau.
/// A rotor of inertia J adds R^T diag(J) R to the inertia of the joints.
struct Transmission {
  std::string name;
  std::vector<int> dofs;                  ///< independent coordinates that it drives
  std::vector<TransmissionMotor> motors;  ///< as many as dofs
  MatrixX ratios;                         ///< R: a row for each motor, a column for each of dofs
  MatrixX inverse;                        ///< R^-1; AddTransmission computes it

  /// Number of its joints, which equals the number of its motors.
  Eigen::Index size() const { return static_cast<Eigen::Index>(dofs.size()); }
  /// Selects the elements of its joints from a vector of all joints, and the reverse.
  VectorX Own(const Eigen::Ref<const VectorX>& joints) const;
  void Put(const VectorX& own, Eigen::Ref<VectorX> joints) const;

  /// w and m from the speeds and torques of all joints of the robot.
  VectorX MotorSpeeds(const Eigen::Ref<const VectorX>& v) const { return ratios * Own(v); }
  VectorX MotorEfforts(const Eigen::Ref<const VectorX>& tau) const { return inverse.transpose() * Own(tau); }
  /// Rotor inertia at its joints, R^T diag(J) R.
  MatrixX RotorInertia() const;
};

/// Distance of a matrix of ratios from a singular one: its smallest singular value over the largest, after scaling each
/// row and then each column to length 1, so that units and gear ratios do not matter. 0 for a singular matrix.
double Regularity(const MatrixX& ratios);

/// Smallest accepted Regularity of a transmission.
inline constexpr double kLeastRegularity = 1e-3;

/// Adds a transmission to a model. Speed and effort limits of its joints become the bounding box of the motors' limits:
/// the largest speed and effort of each joint for any motor speeds and efforts. Code that uses a single joint's limits
/// thus never underestimates them; Actuator has the joint limits of the motors.
/// @throws InvalidArgument for sizes that do not fit, a joint that another transmission drives, or a Regularity below
/// kLeastRegularity.
void AddTransmission(Transmission transmission, RobotModel& model);

}  // namespace gaitwright
