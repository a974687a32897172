// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "kinematics/model/derive_legs.h"

namespace gaitwright {

/// Content of a robot.yaml; all of it is optional. Each item has its line; docs/robot-yaml.md explains the keys.
struct RobotYaml : LegChoices {
  /// A value of a joint, in the units of a prismatic joint (m, N) if `sliding`, else of a revolute one (rad, N m).
  struct JointPosition {
    std::string joint;
    double position = 0.0;
    int line = 0;
  };
  /// Given gains of a joint [N m/rad, N m s/rad]; of a prismatic joint [N/m, N s/m].
  struct JointGains {
    std::string joint;
    std::optional<double> stiffness, damping;
    bool sliding = false;
    int line = 0;
  };
  /// Given limits of a joint [rad, rad/s, N m]; of a prismatic joint [m, m/s, N].
  struct JointLimits {
    std::string joint;
    std::optional<double> lower, upper, velocity, effort;
    bool sliding = false;
    int line = 0;
  };
  /// Given data of a joint's motor and losses; see Motor and Joint.
  struct JointMotor {
    std::string joint;
    std::optional<double> corner_speed, no_load_speed, continuous_effort, thermal_s, rotor_inertia;
    std::optional<double> acceleration_limit, jerk_limit, damping, friction;
    bool has_units = false;  ///< a key shows whether the joint is prismatic
    bool sliding = false;
    int line = 0;
  };

  /// A motor of a transmission, with its row of ratios; units are those of a linear motor if `sliding`.
  struct SharedMotor {
    std::string name;
    std::vector<double> ratios;
    std::optional<double> effort, velocity, corner_speed, no_load_speed, continuous_effort, thermal_s, rotor_inertia;
    bool sliding = false;
    int line = 0;
  };
  /// Motors that drive several joints together; see Transmission.
  struct SharedDrive {
    std::string name;
    std::vector<std::string> joints;
    std::vector<SharedMotor> motors;
    int line = 0;
  };

  std::string name, description;
  double scale = 1.0;                  ///< factor on the lengths of the URDF
  std::optional<Vector3> forward, up;  ///< perpendicular axes of the root link; both are given or neither
  /// A link that the robot may lie on.
  struct Rest {
    std::string link;
    int line = 0;
  };
  std::vector<Rest> rests;
  std::vector<JointLimits> limits;
  std::vector<JointPosition> standing;
  std::vector<JointGains> gains;
  std::vector<JointMotor> motors;
  std::vector<SharedDrive> transmissions;
  std::optional<double> standing_base_height_m, nominal_speed_m_s;
  int height_line = 0;  ///< line of standing_base_height_m
};

/// Reads the text of a robot.yaml. @throws InvalidArgument with the line, for invalid YAML, an unknown key (with the
/// nearest one), a duplicate key, a wrong kind of value, a number that is not finite or out of range, a sole that is
/// not a convex polygon, or a foot whose keys contradict its type.
RobotYaml ParseRobotYaml(const std::string& text);

}  // namespace gaitwright
