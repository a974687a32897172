// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/model/robot_model.h"

namespace gaitwright::examples {

/// Step response of a second-order system,  x'' = w^2 (1 - x) - 2 zeta w x',  from rest:
///   x = 1 - (a e^{b t} - b e^{a t}) / (a - b),   a, b = w (-zeta +- sqrt(zeta^2 - 1));
/// with zeta < 1 it overshoots by e^{-pi zeta / sqrt(1 - zeta^2)}, with zeta >= 1 it does not overshoot.
/// Astrom and Murray, Feedback Systems, 2008, chapter 6.
double SecondOrderStep(double frequency_rad_s, double damping_ratio, double time_s);

/// Response of a joint to a step of its target, as a fraction of the step.
struct JointStep {
  double stiffness = 0.0, damping = 0.0;  ///< [N m/rad], [N m s/rad]
  double inertia_kg_m2 = 0.0;             ///< I: diagonal element of the mass matrix, all other joints held
  double frequency_rad_s = 0.0;           ///< w = sqrt(kp / I)
  double damping_ratio = 0.0;             ///< zeta = kd / (2 sqrt(kp I))
  double torque_use = 0.0;                ///< largest fraction of the motor's limit; at 1 the formula is not valid
  double step_s = 0.0;
  std::vector<double> simulated = {}, formula = {};  ///< after each step_s
};

/// Effect of kp and kd on one joint alone: all other joints are held, and the target of this joint steps. Simulates
///   I q'' = kp (q_target - q) - kd q'
/// without joint losses, and compares it with the closed form. A higher kp makes the response faster, with more
/// overshoot; a higher kd reduces the overshoot, and with zeta above 1 the response is slow. The simulation has no
/// fixed base: instead, the base is a million times as heavy, and the whole robot falls freely, so that no link has
/// weight.
/// @param step_rad  step of the target, not 0.
/// @throws InvalidArgument if the joint does not exist, the stiffness is 0 or less, or the damping is below 0.
JointStep StepJoint(const RobotModel& model, const std::string& joint, double stiffness, double damping,
                    double step_rad);

/// Characteristic values of a step response. A level that is not reached counts as reached at the end.
struct StepShape {
  double rise_s = 0.0;      ///< from 10 % to 90 %
  double overshoot = 0.0;   ///< fraction of the step
  double settling_s = 0.0;  ///< time after which it stays within 2 %
};

/// @param response  one value after each step_s.
StepShape ShapeOf(const std::vector<double>& response, double step_s);

}  // namespace gaitwright::examples
