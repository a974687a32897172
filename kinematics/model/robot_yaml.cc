// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/robot_yaml.h"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>

#include "kinematics/base/options.h"

namespace gaitwright {
namespace {

double Number(const YAML::Node& node, const std::string& key) {
  double value = 0.0;
  try {
    value = node.as<double>();
  } catch (const YAML::Exception&) {
    throw InvalidArgument(fmt::format("robot.yaml, line {}: '{}' is not a number", node.Mark().line + 1, key));
  }
  if (!std::isfinite(value)) {
    throw InvalidArgument(
        fmt::format("robot.yaml, line {}: '{}' is {}; a finite number is needed", node.Mark().line + 1, key, value));
  }
  return value;
}

void CheckKeys(const YAML::Node& node, const std::string& where, const std::vector<std::string>& known) {
  if (!node.IsMap()) throw InvalidArgument(fmt::format("robot.yaml: {} must be a map of keys to values", where));
  for (const auto& entry : node) {
    const auto key = entry.first.as<std::string>();
    if (std::find(known.begin(), known.end(), key) == known.end()) {
      throw InvalidArgument(fmt::format("robot.yaml, line {}: unknown key '{}' in {}; the nearest is '{}'",
                                        entry.first.Mark().line + 1, key, where, NearestName(key, known)));
    }
  }
}

FootType ParseFootType(const std::string& text) {
  const std::vector<std::string> names = {"point", "sphere", "line", "sole"};
  const auto at = std::find(names.begin(), names.end(), text);
  if (at == names.end())
    throw InvalidArgument(fmt::format("robot.yaml: foot type '{}' is unknown; there are {}", text, QuotedList(names)));
  return static_cast<FootType>(at - names.begin());
}

FootOverride ParseFoot(const YAML::Node& node) {
  CheckKeys(node, "feet", {"link", "type", "radius_m", "sole_m"});
  FootOverride foot;
  if (!node["link"]) throw InvalidArgument("robot.yaml: a foot needs the key 'link'");
  foot.link = node["link"].as<std::string>();
  if (node["type"]) foot.type = ParseFootType(node["type"].as<std::string>());
  if (node["radius_m"]) foot.radius_m = Number(node["radius_m"], "radius_m");
  for (const YAML::Node& corner : node["sole_m"]) {
    foot.sole_m.emplace_back(Number(corner[0], "sole_m"), Number(corner[1], "sole_m"));
  }
  return foot;
}

RobotYaml Parse(const YAML::Node& root) {
  RobotYaml yaml;
  if (!root || root.IsNull()) return yaml;
  CheckKeys(root, "the file",
            {"name", "description", "feet", "standing", "standing_base_height_m", "gains", "nominal_speed_m_s"});
  if (root["name"]) yaml.name = root["name"].as<std::string>();
  if (root["description"]) yaml.description = root["description"].as<std::string>();
  for (const YAML::Node& foot : root["feet"]) yaml.feet.push_back(ParseFoot(foot));
  for (const auto& entry : root["standing"]) {
    const auto joint = entry.first.as<std::string>();
    yaml.standing[joint] = Number(entry.second, joint);
  }
  for (const auto& entry : root["gains"]) {
    CheckKeys(entry.second, "gains", {"stiffness_nm_rad", "damping_nm_s_rad"});
    RobotYaml::JointGains& gains = yaml.gains[entry.first.as<std::string>()];
    if (entry.second["stiffness_nm_rad"])
      gains.stiffness = Number(entry.second["stiffness_nm_rad"], "stiffness_nm_rad");
    if (entry.second["damping_nm_s_rad"]) gains.damping = Number(entry.second["damping_nm_s_rad"], "damping_nm_s_rad");
    if (gains.stiffness < 0.0 || gains.damping < 0.0) throw InvalidArgument("robot.yaml: gains must not be negative");
  }
  const auto optional = [&](const char* key) -> std::optional<double> {
    if (!root[key]) return std::nullopt;
    const double value = Number(root[key], key);
    if (value <= 0.0) throw InvalidArgument(fmt::format("robot.yaml: '{}' is {}; it must be positive", key, value));
    return value;
  };
  yaml.standing_base_height_m = optional("standing_base_height_m");
  yaml.nominal_speed_m_s = optional("nominal_speed_m_s");
  return yaml;
}

}  // namespace

RobotYaml ParseRobotYaml(const std::string& text) {
  try {
    return Parse(YAML::Load(text));
  } catch (const YAML::Exception& error) {
    throw InvalidArgument(fmt::format("robot.yaml, line {}: {}", error.mark.line + 1, error.msg));
  }
}

}  // namespace gaitwright
