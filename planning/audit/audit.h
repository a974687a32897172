// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "kinematics/base/options.h"
#include "kinematics/base/result.h"
#include "kinematics/model/robot_model.h"
#include "planning/audit/audit_report.h"
#include "planning/audit/start_posture.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// Sampling rate and margins of the audit. `start` and `margins` request additional checks and results.
struct AuditOptions {
  double rate_hz = 1000.0;
  double derate_torque = 1.0, derate_speed = 1.0, derate_acceleration = 1.0, derate_jerk = 1.0;
  double derate_continuous = 1.0;
  double jerk_over_s = 0.01;
  double start_tolerance_rad = 0.05, start_tolerance_m = 0.005, start_tilt_rad = 0.1;
  double start_speed_rad_s = 0.1, start_speed_m_s = 0.02;
  bool margins = false;               ///< report the margin of each check, with self-collision and body clearance
  std::optional<StartPosture> start;  ///< measured before the first command; enables the check start_posture

  OptionFields Fields() {
    const auto share = [](const char* key, double* target, const char* what) {
      return OptionField{key, target, "1", 0.01, 1.0, std::string("Share of the ") + what + " that a plan may use."};
    };
    return WithBasics(
        {"rate_hz", "derate_torque", "derate_speed"},
        {{"rate_hz", &rate_hz, "Hz", 10.0, 10000.0, "Rate at which the plan is sampled for the checks."},
         share("derate_torque", &derate_torque, "joints' torque limits (also of torque-speed curves)"),
         share("derate_speed", &derate_speed, "joints' speed limits (also of torque-speed curves)"),
         share("derate_acceleration", &derate_acceleration, "joints' acceleration limits"),
         share("derate_jerk", &derate_jerk, "joints' jerk limits"),
         share("derate_continuous", &derate_continuous, "joints' continuous torque limits"),
         {"jerk_over_s", &jerk_over_s, "s", 1e-4, 0.1,
          "Time interval over which jerk is computed as the change of acceleration."},
         {"start_tolerance_rad", &start_tolerance_rad, "rad", 0.0, 1.0,
          "Largest deviation of a revolute joint's measured position from the first command."},
         {"start_tolerance_m", &start_tolerance_m, "m", 0.0, 0.1,
          "Largest deviation of a prismatic joint's measured position from the first command."},
         {"start_tilt_rad", &start_tilt_rad, "rad", 0.0, 1.0,
          "Largest tilt of the measured base relative to the first command."},
         {"start_speed_rad_s", &start_speed_rad_s, "rad/s", 0.0, 10.0,
          "Largest angular speed of a revolute joint or the base in the first command, because the robot is at rest "
          "then."},
         {"start_speed_m_s", &start_speed_m_s, "m/s", 0.0, 10.0,
          "Largest linear speed of a prismatic joint or the base in the first command, because the robot is at "
          "rest then."}});
  }
};

/// Checks a plan densely between its nodes, with the model's own dynamics and independently of the planner. Each failed
/// check is reported once for each joint, foot or pair of links, at its worst time.
///
///   dynamics       residual of the equations of motion: at most 0.02 m g of force and 0.02 m g h of moment; at a joint
///                  also at most 5 % of its effort limit
///   flight         from one row after all feet have left the ground to one row before the first touch-down, instead of
///                  dynamics of the base: the centre of mass falls freely, to a force of 0.02 m g, and the angular
///                  momentum about it is constant, to a moment of 0.02 m g l (l: leg length). Both hold at each sample
///                  by the accelerations, and on average over the flight by the velocities
///   unilateral     no pulling force; centre of pressure inside the part of the sole that is on its surface
///   friction_cone  tangential force at most friction times normal force
///   zmp_support    multibody ZMP, on the plane of the contacts, inside the hull of the scheduled soles (only the parts
///                  on their surfaces), or within 2 mm of the hull if it is a line. For a line, and at a change of
///                  contacts, the tolerance is max(2 mm, 1e-3 h m g / F) under a load F. The plan's ZMP reference is
///                  checked to 5 mm, except between rows with a change of stance. For contacts that are not in one
///                  plane, the contact forces are checked instead
///   foot_clearance the whole foot against all solids of the terrain (SolidsOf): at most 0.1 mm deep in swing, 1 mm in
///                  stance, and a value between them near both ends of a swing (SwingDepth)
///   body_clearance all other shapes against the solids of the terrain
///   consistency    the columns agree with each other:
///                  q with v, v with a: 0.01 m/s and 0.02 rad/s, 1 m/s^2 and 100 rad/s^2, mean over a step;
///                  centre of mass with the joints, and with its own derivatives: 1 mm, 0.01 m/s, 0.1 m/s^2;
///                  ZMP reference with the multibody ZMP: 2 mm (at small vertical force F: 1e-3 h m g / F);
///                  pendulum frequency with sqrt(g / h): 2 %;
///                  feet with footholds and swings: 1 mm and 1e-3 rad; one foothold for each contact interval and one
///                  swing for each gap between two, at their times to 1e-6 s; the goal with the command, to 3 % of the
///                  leg's length
///   start_posture  the first command is at rest and within a tolerance of the measured joints, if these are given
///   joint_...      position, velocity, acceleration, jerk and torque within limits; torque_speed inside the motor's
///                  curve; continuous_torque at most the continuous limit (JointWatch). Speeds and torques are those of
///                  the motors (Actuator), also with a transmission between motors and joints. Torques include the
///                  losses of joint and rotor (MotorEffort). Unknown limits are not checked
///
/// In a hanging part (HangingGait), the base is held externally by forces that are not checked; it must not move. A
/// plan of the pipeline stays below a tenth of most of these tolerances, and below half of that of the ZMP.
///
/// Failure only if the plan does not fit the robot, or lasts over an hour.
Result<AuditReport> Audit(const RobotModel& model, const MotionPlan& plan, const AuditOptions& options);

}  // namespace gaitwright
