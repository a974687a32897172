// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "kinematics/model/derive_legs.h"

namespace gaitwright {

/// What a robot.yaml says; everything may be left out.
struct RobotYaml {
  /// Gains of one joint; 0 where they are derived. Stiffness [N m/rad], damping [N m s/rad], of a sliding one [N/m, N
  /// s/m].
  struct JointGains {
    double stiffness = 0.0, damping = 0.0;
  };
  std::string name, description;
  std::vector<FootOverride> feet;
  std::map<std::string, double> standing;   ///< joint to position
  std::map<std::string, JointGains> gains;  ///< by joint
  std::optional<double> standing_base_height_m, nominal_speed_m_s;
};

/// Reads the text of a robot.yaml. @throws InvalidArgument on YAML that does not parse, an unknown key (names the
/// nearest), a number that is not finite, a wrong kind of value.
RobotYaml ParseRobotYaml(const std::string& text);

}  // namespace gaitwright
