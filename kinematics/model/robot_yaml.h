// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "kinematics/model/derive_legs.h"

namespace gaitwright {

/// What a robot.yaml says; everything may be left out. Each item has the line it stands on; docs/robot-yaml.md tells
/// what the keys mean.
struct RobotYaml : LegChoices {
  /// A value of a joint, in the units of `sliding` joints (m, N) or turning ones (rad, N m).
  struct JointPosition {
    std::string joint;
    double position = 0.0;
    int line = 0;
  };
  /// Gains of a joint that are given: [N m/rad, N m s/rad], of a sliding one [N/m, N s/m].
  struct JointGains {
    std::string joint;
    std::optional<double> stiffness, damping;
    bool sliding = false;
    int line = 0;
  };
  /// Limits of a joint that are given: [rad, rad/s, N m], of a sliding one [m, m/s, N].
  struct JointLimits {
    std::string joint;
    std::optional<double> lower, upper, velocity, effort;
    bool sliding = false;
    int line = 0;
  };
  /// What is given of a joint's motor and of what the joint itself takes; see Motor and Joint.
  struct JointMotor {
    std::string joint;
    std::optional<double> corner_speed, no_load_speed, continuous_effort, thermal_s, rotor_inertia;
    std::optional<double> acceleration_limit, jerk_limit, damping, friction;
    bool has_units = false;  ///< any key tells whether the joint slides
    bool sliding = false;
    int line = 0;
  };

  /// A motor of a transmission, with its row of ratios; units are those of a motor that slides where `sliding`.
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
  double scale = 1.0;                ///< by which the URDF's lengths are multiplied
  std::optional<Vector3> ahead, up;  ///< axes of the root link; `up` too where `ahead` is given, and across it
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
  int height_line = 0;  ///< of standing_base_height_m
};

/// Reads the text of a robot.yaml. @throws InvalidArgument with the line, on what is no YAML, an unknown key (names the
/// nearest), a key that stands there twice, a wrong kind of value, a number that is not finite or out of its range, a
/// sole that is no convex polygon, a foot whose keys contradict its type.
RobotYaml ParseRobotYaml(const std::string& text);

}  // namespace gaitwright
