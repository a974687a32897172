// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/dynamics/dynamics.h"
#include "planning/plan/motion_plan.h"
#include "planning/plan/sample_plan.h"
#include "playback/control/controller.h"
#include "playback/control/gains.h"

namespace gaitwright::examples {

/// Joint torques that carry one additional kilogram at the centre of mass. Its weight is distributed over the feet as
/// the plan distributes the robot's own weight:
///   Y = -sum over the feet of J_i^T w_i / m,  the rows of the independent joints, size n [N m/kg].
/// @param q         configuration of the robot, size nq.
/// @param wrenches  w_i by foot, from the plan at that time.
VectorX TorquePerKilogram(const RobotModel& model, const VectorX& q, const std::vector<ContactWrench>& wrenches,
                          DynamicsScratch& scratch);

/// Joint PD that estimates the payload from the joint errors: a payload makes the joints sag, and the estimate p grows
/// until its torque carries the payload and the joints no longer sag. Kp, Kd are the gains, e = q - q_planned:
///   tau = tau_planned + Y p - Kp e - Kd e',   s = e' + Kp / Kd e,   p' = -gain Y^T s,   p >= 0.
/// With feet at rest Y^T e' = g z', where z is the height of the body above its plan (d'Alembert).
/// Slotine and Li, IJRR 6(3), 1987, doi:10.1177/027836498700600303, with one unknown. The plan's torques replace the
/// torques at their reference velocity; this is accurate enough while the estimate changes slowly compared with the PD.
///
/// Tuning
///   the estimate takes too long            raise rate_per_s
///   it oscillates or reacts to footfalls   lower rate_per_s: well below Kp / Kd, 14 / s for a1
class AdaptivePd : public Controller {
 public:
  /// Model and plan must outlive the controller.
  /// @param rate_per_s  approximate decay rate of the estimate's error [1/s]; 0 for PD alone.
  /// @throws InvalidArgument if the rate is below 0, or if the plan does not begin with feet on the ground.
  AdaptivePd(const RobotModel& model, const MotionPlan& plan, double rate_per_s);

  JointCommand Update(const ControlInput& input) override;
  void Reset() override { payloads_kg_.clear(); }
  std::string Name() const override { return "adaptive-pd"; }

  /// The estimate after each step, from the time when the robot is released.
  const std::vector<double>& payloads_kg() const { return payloads_kg_; }

 private:
  const RobotModel& model_;
  const MotionPlan& plan_;
  Gains gains_;
  double gain_ = 0.0;  // [kg^2/J]
  std::vector<double> payloads_kg_;
  DynamicsScratch scratch_;
  WholeBodySample wanted_;
};

}  // namespace gaitwright::examples
