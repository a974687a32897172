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

/// Torques by which the joints of the legs carry one more kilogram at the centre of mass, where the ground's share in
/// it is spread over the feet as the plan spreads the robot's own weight:
///   Y = -sum over the feet of J_i^T w_i / m,  the rows of the independent joints, size n [N m/kg].
/// @param q         size nq; where the robot is.
/// @param wrenches  w_i by foot, of the plan at that time.
VectorX TorquePerKilogram(const RobotModel& model, const VectorX& q, const std::vector<ContactWrench>& wrenches,
                          DynamicsScratch& scratch);

/// Joint PD that learns what the robot carries, from its joints: a payload makes the joints sag, and sagging makes
/// the estimate p grow until its torque carries the payload and nothing sags. Kp, Kd are the gains, e = q - q_planned:
///   tau = tau_planned + Y p - Kp e - Kd e',   s = e' + Kp / Kd e,   p' = -gain Y^T s,   p >= 0.
/// With feet at rest Y^T e' = g z', where z is how far the body is over its plan (d'Alembert): it learns by sagging.
/// Slotine and Li, IJRR 6(3), 1987, doi:10.1177/027836498700600303, with one unknown, and with the plan's torques in
/// place of those at their reference velocity, which is near enough while the estimate is slow beside the PD.
///
/// Tuning
///   the estimate takes too long            raise rate_per_s
///   it swings, or follows every footfall   lower rate_per_s: well below Kp / Kd, 14 / s for a1
class AdaptivePd : public Controller {
 public:
  /// @param rate_per_s  about that fast the estimate's error dies away; 0 for PD alone. Model and plan must outlive it.
  /// @throws InvalidArgument for a rate below 0, and a plan that does not begin with feet on the ground.
  AdaptivePd(const RobotModel& model, const MotionPlan& plan, double rate_per_s);

  JointCommand Update(const ControlInput& input) override;
  void Reset() override { payloads_kg_.clear(); }
  std::string Name() const override { return "adaptive-pd"; }

  /// The estimate after each step, from when the robot was let go.
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
