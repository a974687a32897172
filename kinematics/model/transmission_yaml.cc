// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>
#include <set>

#include "kinematics/model/robot_yaml_shape_internal.h"
#include "kinematics/model/transmission_yaml_internal.h"
#include "kinematics/model/unit_keys_internal.h"

namespace gaitwright {
namespace {

std::string NameOfPart(const YamlMap& map, const YAML::Node& node, const char* what) {
  std::string name = map.Text("name");
  if (name.empty()) RefuseYaml(node, fmt::format("{} has an empty 'name'", what));
  return name;
}

/// Reads curve, thermal limit and rotor, with the same keys as for the motor of one joint.
void ParseTraits(const YamlMap& map, UnitKeys& keys, const YAML::Node& node, RobotYaml::SharedMotor& motor) {
  motor.corner_speed = keys.Take("corner_velocity_rad_s", "corner_velocity_m_s");
  motor.no_load_speed = keys.Take("no_load_velocity_rad_s", "no_load_velocity_m_s");
  motor.continuous_effort = keys.Take("continuous_nm", "continuous_n");
  motor.thermal_s = map.InRange("thermal_s");
  motor.rotor_inertia = keys.Take("rotor_inertia_kg_m2", "rotor_mass_kg");
  if (motor.corner_speed.has_value() != motor.no_load_speed.has_value()) {
    RefuseYaml(node, fmt::format("motor '{}' has only one end of its torque-speed curve; give both the corner velocity "
                                 "and the no-load velocity, or neither",
                                 motor.name));
  }
  if (motor.corner_speed && *motor.corner_speed >= *motor.no_load_speed) {
    RefuseYaml(node, fmt::format("motor '{}' has a corner velocity of {}, which is not below its no-load velocity of "
                                 "{}",
                                 motor.name, *motor.corner_speed, *motor.no_load_speed));
  }
  if (motor.continuous_effort && motor.effort && *motor.continuous_effort > *motor.effort) {
    RefuseYaml(node, fmt::format("motor '{}' has a continuous effort of {}, above its limit of {}", motor.name,
                                 *motor.continuous_effort, *motor.effort));
  }
  if (motor.thermal_s && !motor.continuous_effort) {
    RefuseYaml(node, fmt::format("motor '{}' has 'thermal_s', the averaging time of the continuous effort, but no "
                                 "'continuous_nm' or 'continuous_n'",
                                 motor.name));
  }
}

RobotYaml::SharedMotor ParseSharedMotor(const YAML::Node& node, const RobotYaml::SharedDrive& drive) {
  const DataShape shape = TransmissionMotorYamlShape();
  const YamlMap map(node, fmt::format("a motor of transmission '{}'", drive.name), shape);
  UnitKeys keys{map};
  RobotYaml::SharedMotor motor;
  motor.line = LineOf(node);
  motor.name = NameOfPart(map, node, "a motor");
  const std::vector<YAML::Node> ratios = ListOf(*map.Find("ratios"), "'ratios'");
  if (ratios.size() != drive.joints.size()) {
    RefuseYaml(*map.Find("ratios"), fmt::format("motor '{}' has {} ratios; transmission '{}' has {} joints", motor.name,
                                                ratios.size(), drive.name, drive.joints.size()));
  }
  for (const YAML::Node& ratio : ratios) {
    motor.ratios.push_back(NumberOf(ratio, "a number of 'ratios'", -kLargestRatio, kLargestRatio));
    if (const double size = std::abs(motor.ratios.back()); size > 0.0 && size < 1.0 / kLargestRatio)
      RefuseYaml(ratio, fmt::format("a number of 'ratios' is {}; accepted: 0, or a magnitude of {:g} or more",
                                    motor.ratios.back(), 1.0 / kLargestRatio));
  }
  motor.effort = keys.Take("effort_nm", "effort_n");
  motor.velocity = keys.Take("velocity_rad_s", "velocity_m_s");
  ParseTraits(map, keys, node, motor);
  motor.sliding = keys.Sliding(node, fmt::format("motor '{}'", motor.name));
  return motor;
}

RobotYaml::SharedDrive ParseTransmission(const YAML::Node& node) {
  const DataShape shape = TransmissionYamlShape();
  const YamlMap map(node, "a transmission", shape);
  RobotYaml::SharedDrive drive;
  drive.line = LineOf(node);
  drive.name = NameOfPart(map, node, "a transmission");
  const std::string who = fmt::format("transmission '{}'", drive.name);
  const std::vector<YAML::Node> joints = ListOf(*map.Find("joints"), "'joints'");
  std::set<std::string> named;
  for (const YAML::Node& joint : joints) {
    drive.joints.push_back(TextOf(joint, "a joint of " + who));
    if (!named.insert(drive.joints.back()).second)
      RefuseYaml(joint, fmt::format("{} names joint '{}' twice", who, drive.joints.back()));
  }
  if (joints.size() < 2 || joints.size() > kMostShared) {
    RefuseYaml(
        *map.Find("joints"),
        fmt::format(
            "{} has {} joints; 2 to {} are accepted; describe the motor of a single joint by 'limits' and 'motors'",
            who, joints.size(), kMostShared));
  }
  const std::vector<YAML::Node> motors = ListOf(*map.Find("motors"), "'motors'");
  if (motors.size() != joints.size()) {
    RefuseYaml(*map.Find("motors"), fmt::format("{} has {} motors but {} joints; it needs one motor for each joint",
                                                who, motors.size(), joints.size()));
  }
  for (const YAML::Node& motor : motors) drive.motors.push_back(ParseSharedMotor(motor, drive));
  return drive;
}

}  // namespace

std::vector<RobotYaml::SharedDrive> ParseTransmissions(const YAML::Node& node) {
  std::vector<RobotYaml::SharedDrive> drives;
  for (const YAML::Node& each : ListOf(node, "'transmissions'")) drives.push_back(ParseTransmission(each));
  return drives;
}

}  // namespace gaitwright
