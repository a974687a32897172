// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "planning/audit/audit.h"
#include "planning/audit/findings.h"
#include "planning/audit/motor_effort.h"
#include "planning/plan/sample_plan.h"

namespace gaitwright {

/// Checks each joint's motion and each motor's speed and effort against their limits, sample by sample. Joints:
/// joint_position, joint_acceleration and joint_jerk. Motors (Actuator): joint_velocity, joint_torque, torque_speed and
/// continuous_torque. A motor has the name of its joint unless it belongs to a transmission.
///
/// Jerk is the change of acceleration over `jerk_over_s`, because the interpolation between rows has jumps of jerk that
/// no motor performs. Continuous effort is the root mean square over the motor's `thermal_s`, or over the whole plan if
/// that is shorter; its time is the end of the worst window.
class JointWatch {
 public:
  /// @param samples  number of samples of the plan.
  JointWatch(const RobotModel& model, const AuditOptions& options, int samples, Findings& findings);

  /// The next sample, 1 / rate_hz after the one before.
  void Look(const WholeBodySample& sample, double time_s);
  /// Call after the last sample.
  void Finish(double time_s);

 private:
  /// A coordinate, the motor with the same index, and the places and the state of their checks.
  struct Watched {
    double lower, upper, speed, acceleration, jerk, effort, continuous;  // derated limits; infinite without a limit
    double position_scale_lower, position_scale_upper;
    int position, velocity, accelerated, jerked, torque, curve, heat;
    std::size_t window;                 // length of the thermal window, in samples
    std::vector<double> accelerations;  // the last ones; empty without a jerk limit
    std::vector<double> squares;        // of the last efforts; empty without a continuous limit
    double sum = 0.0;
  };
  Watched Watch(int dof, int samples);
  void LookAtMotion(Watched& joint, double q, double speed, double a, double time_s);
  void LookAtEffort(Watched& joint, const Motor& motor, double effort, double v, double time_s);
  void LookAtHeat(Watched& joint, double effort, double time_s);

  const RobotModel& model_;
  const AuditOptions& options_;
  Findings& findings_;
  MotorEffort effort_;
  std::size_t jerk_steps_;
  std::vector<Watched> joints_;  // by dof
  std::size_t count_ = 0;
};

/// Motor data that are missing, so that checks were not possible: one line per check, and one for curves whose peak is
/// a placeholder.
std::vector<std::string> UnknownOfMotors(const RobotModel& model);

}  // namespace gaitwright
