// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "planning/audit/audit.h"
#include "planning/audit/findings.h"
#include "planning/audit/motor_effort.h"
#include "planning/plan/sample_plan.h"

namespace gaitwright {

/// Checks each joint's motion and each motor's speed and effort against their limits, sample by sample: the checks
/// joint_position, joint_acceleration and joint_jerk of the joints; joint_velocity, joint_torque, torque_speed and
/// continuous_torque of the motors (Actuator), which have the names of their joints but for those of transmissions.
///
/// Jerk is the change of acceleration over `jerk_over_s`, because the interpolation between rows has jumps of jerk
/// that no motor sees. Continuous effort is the root mean square over the motor's `thermal_s`, or over the whole plan
/// where that is shorter; its time is the end of the worst window.
class JointWatch {
 public:
  /// @param samples  how many there will be.
  JointWatch(const RobotModel& model, const AuditOptions& options, int samples, Findings& findings);

  /// The next sample, 1 / rate_hz after the one before.
  void Look(const WholeBodySample& sample, double time_s);
  /// After the last one.
  void Finish(double time_s);

 private:
  /// A coordinate, the motor of the same index, the places of their checks and their state.
  struct Watched {
    double lower, upper, speed, acceleration, jerk, effort, continuous;  // as derated; infinite for none
    double position_scale_lower, position_scale_upper;
    int position, velocity, accelerated, jerked, torque, curve, heat;
    std::size_t window;                 // of heat, in samples
    std::vector<double> accelerations;  // the last ones; empty without a limit of jerk
    std::vector<double> squares;        // of effort, the last ones; empty without a continuous limit
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

/// Unknown motor data, because of which checks could not be applied; one line per check, and one for curves whose peak
/// is a placeholder.
std::vector<std::string> UnknownOfMotors(const RobotModel& model);

}  // namespace gaitwright
