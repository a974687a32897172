// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/model/robot_model.h"

namespace gaitwright::examples {

/// Position after a step of the target from 0 to 1, of  x'' = w^2 (1 - x) - 2 zeta w x'  from rest:
///   x = 1 - (a e^{b t} - b e^{a t}) / (a - b),   a, b = w (-zeta +- sqrt(zeta^2 - 1));
/// with zeta < 1 it overshoots by e^{-pi zeta / sqrt(1 - zeta^2)}, with zeta >= 1 not at all.
/// Astrom and Murray, Feedback Systems, 2008, chapter 6.
double SecondOrderStep(double frequency_rad_s, double damping_ratio, double time_s);

/// How a joint answered to a step of its target, in shares of the step.
struct JointStep {
  double stiffness = 0.0, damping = 0.0;  ///< [N m/rad], [N m s/rad]
  double inertia_kg_m2 = 0.0;             ///< I, felt at the joint with all others held: of the mass matrix's diagonal
  double frequency_rad_s = 0.0;           ///< w = sqrt(kp / I)
  double damping_ratio = 0.0;             ///< zeta = kd / (2 sqrt(kp I))
  double torque_use = 0.0;                ///< largest share of the motor's limit; at 1 the formula no longer holds
  double step_s = 0.0;
  std::vector<double> simulated = {}, formula = {};  ///< after each step_s
};

/// What kp and kd do to a joint by itself: all others are held, the target of this one jumps, and
///   I q'' = kp (q_target - q) - kd q'
/// is played in physics, without losses in the joint, and set beside the known answer. More kp is quicker and
/// overshoots; more kd overshoots less, and with zeta over 1 is slow. The physics knows of no fixed base: the base is
/// made a million times as heavy, and all of it falls freely, so that nothing has weight.
/// @param step_rad  of the target, other than 0.
/// @throws InvalidArgument for a joint that there is not, a stiffness that is not more than 0, a damping below 0.
JointStep StepJoint(const RobotModel& model, const std::string& joint, double stiffness, double damping,
                    double step_rad);

/// The figures by which a step response is judged; what is not reached by its end counts as reached there.
struct StepShape {
  double rise_s = 0.0;      ///< from 10 % to 90 %
  double overshoot = 0.0;   ///< share of the step
  double settling_s = 0.0;  ///< after which it stays within 2 %
};

/// @param response  after each step_s.
StepShape ShapeOf(const std::vector<double>& response, double step_s);

}  // namespace gaitwright::examples
