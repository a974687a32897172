// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/spatial/pose.h"
#include "planning/plan/gait.h"
#include "planning/plan/motion_plan.h"
#include "playback/log/playback_log.h"

namespace gaitwright {

/// Input of a controller at the start of a step: the measured state, exact in playbacks without sensor errors.
struct ControlInput {
  double time_s = 0.0;  ///< on the plan's clock; runs on after the plan's end
  double step_s = 0.001;
  VectorX q, v;                         ///< in the orders of RobotModel
  std::vector<ContactWrench> wrenches;  ///< by foot, of the last step, about the contact frame's origin
  FootSet contact = 0;                  ///< feet that carried force in the last step
  /// Number of steps after `time_s` at which the motors compare their joints with the command: 1 for motors that are
  /// solved implicitly, 0 with play.actuation=torque.
  double lead_steps = 1.0;
};

/// Command to the motors until the next call, by independent joint:
///   tau = tau_ff + stiffness (q - q_measured) + damping (v - v_measured),  within +-effort limit.
/// A motor solves this implicitly, with the measured state at the end of the step, so that every gain is stable; with
/// play.actuation=torque, the state is that at the start of the step. A step of length h is semi-implicit, q' = q + h
/// v', v' = v + h a(q), so that velocities belong to the middle of a step. Targets fit a trajectory to second order
/// when sampled as q(t + lead), v(t + lead - h/2), tau_ff(t) with lead = lead_steps h.
struct JointCommand {
  VectorX q, v;                ///< targets, size n [rad], [rad/s]
  VectorX tau_ff;              ///< feed-forward [N m]
  VectorX stiffness, damping;  ///< [N m/rad], [N m s/rad]; not negative
};

/// Whether all numbers are finite.
inline bool IsFinite(const JointCommand& command) {
  return command.q.allFinite() && command.v.allFinite() && command.tau_ff.allFinite() &&
         command.stiffness.allFinite() && command.damping.allFinite();
}

/// Interface of controllers: state in, command out. A controller must be deterministic and must not measure time with a
/// clock of its own: `time_s` may stand still while a robot settles.
class Controller {
 public:
  virtual ~Controller() = default;

  /// Called once per step. @return all vectors of size n = RobotModel::num_dofs(), finite.
  virtual JointCommand Update(const ControlInput& input) = 0;

  /// Called before a playback: resets the state left by an earlier playback.
  virtual void Reset() {}

  /// Estimate of the base at the last update, for the log; null if the controller uses the true state.
  virtual const BaseEstimate* Estimate() const { return nullptr; }

  /// Name for logs and reports, such as "joint-pd".
  virtual std::string Name() const = 0;
};

}  // namespace gaitwright
