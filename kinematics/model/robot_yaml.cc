// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/robot_yaml.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kinematics/base/options.h"
#include "kinematics/base/strict_yaml_internal.h"
#include "kinematics/model/base_axes.h"
#include "kinematics/model/robot_yaml_shape.h"
#include "kinematics/model/robot_yaml_shape_internal.h"
#include "kinematics/model/transmission_yaml_internal.h"
#include "kinematics/model/unit_keys_internal.h"
#include "kinematics/model/yaml_line.h"
#include "kinematics/spatial/convex_hull.h"

namespace gaitwright {
namespace {

constexpr double kSmallestSole = 1e-6;  // [m^2]

FootType ParseFootType(const YAML::Node& node) {
  const std::vector<std::string>& names = FootTypeNames();
  const std::string text = TextOf(node, "'type'");
  const auto at = std::find(names.begin(), names.end(), text);
  if (at == names.end()) {
    RefuseYaml(node, fmt::format("foot type '{}' is unknown; the types are {}", text, QuotedList(names)));
  }
  return static_cast<FootType>(at - names.begin());
}

/// Whether the segments a and b cross at an inner point of both.
bool SegmentsCross(const Vector2& a0, const Vector2& a1, const Vector2& b0, const Vector2& b1) {
  return Cross(a1 - a0, b0 - a0) * Cross(a1 - a0, b1 - a0) < 0.0 &&
         Cross(b1 - b0, a0 - b0) * Cross(b1 - b0, a1 - b0) < 0.0;
}

bool CrossesItself(const std::vector<Vector2>& corners) {
  const std::size_t n = corners.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 2; j < n; ++j) {
      if (SegmentsCross(corners[i], corners[i + 1], corners[j], corners[(j + 1) % n])) return true;
    }
  }
  return false;
}

/// The corners counter-clockwise, each once. Refuses an outline that is not a convex polygon.
std::vector<Vector2> ParseSole(const YAML::Node& node) {
  std::vector<Vector2> corners;
  for (const YAML::Node& corner : ListOf(node, "'sole_m'")) {
    const std::vector<YAML::Node> xy = ListOf(corner, "a corner of 'sole_m'");
    if (xy.size() != 2)
      RefuseYaml(corner, fmt::format("a corner of 'sole_m' has {} numbers; [x, y] is needed", xy.size()));
    const auto at = [&](std::size_t i) { return NumberOf(xy[i], "a corner of 'sole_m'", -kLongestPart, kLongestPart); };
    corners.emplace_back(at(0), at(1));
  }
  if (corners.size() < 3)
    RefuseYaml(node, fmt::format("'sole_m' has {} corners; three or more are needed", corners.size()));
  if (corners.size() > kMaxSoleCorners)
    RefuseYaml(node, fmt::format("'sole_m' has {} corners; at most {} are accepted", corners.size(), kMaxSoleCorners));
  if (CrossesItself(corners))
    RefuseYaml(node, "the outline 'sole_m' crosses itself; give its corners in order around it");
  Polygon hull = ConvexHull(corners);
  if (Area(hull) < kSmallestSole)
    RefuseYaml(node,
               fmt::format("'sole_m' has an area of {:.3g} m^2; {} or more is needed", Area(hull), kSmallestSole));
  const double share = std::abs(ShareOfHull(corners));
  if (std::abs(share - 1.0) > 1e-9) {
    RefuseYaml(node, fmt::format("'sole_m' is not convex: it covers {:.0f} % of its hull; give the corners of the hull",
                                 100.0 * share));
  }
  return hull;
}

FootOverride ParseFoot(const YAML::Node& node) {
  const DataShape shape = FootYamlShape();
  const YamlMap map(node, "a foot", shape);
  FootOverride foot;
  foot.line = LineOf(node);
  foot.link = map.Text("link");
  if (foot.link.empty()) RefuseYaml(node, "a foot needs the key 'link'");
  if (const YAML::Node* type = map.Find("type")) foot.type = ParseFootType(*type);
  foot.radius_m = map.InRange("radius_m").value_or(0.0);
  if (const YAML::Node* sole = map.Find("sole_m")) foot.sole_m = ParseSole(*sole);
  foot.sole_give_m = map.InRange("sole_give_m");
  const bool flat = foot.type == FootType::kSole || foot.type == FootType::kLine;
  const std::string who = fmt::format("foot '{}'", foot.link);
  if (flat && foot.sole_m.empty()) RefuseYaml(node, who + " of type sole or line needs its corners: 'sole_m'");
  if (foot.type && !flat && !foot.sole_m.empty()) RefuseYaml(node, who + " is not a sole or line but has 'sole_m'");
  if (foot.radius_m > 0.0 && (foot.type.value_or(FootType::kSphere) != FootType::kSphere || !foot.sole_m.empty())) {
    RefuseYaml(node, who + " is not a sphere but has 'radius_m'");
  }
  if (foot.sole_give_m && (foot.type || foot.radius_m > 0.0 || !foot.sole_m.empty())) {
    RefuseYaml(node, who + " has 'sole_give_m', which is for soles found in the link's shapes, but also its own " +
                         (foot.type             ? "'type'"
                          : foot.sole_m.empty() ? "'radius_m'"
                                                : "'sole_m'"));
  }
  return foot;
}

LegOverride ParseLeg(const YamlMap::Entry& entry) {
  const std::string what = fmt::format("leg '{}'", entry.key);
  const DataShape shape = LegYamlShape();
  const YamlMap map(entry.value, what, shape);
  LegOverride leg;
  leg.foot = entry.key;
  leg.line = LineOf(entry.key_node);
  leg.knee = map.Text("knee");
  if (const YAML::Node* joints = map.Find("joints")) {
    for (const YAML::Node& joint : ListOf(*joints, what + ", 'joints'")) leg.joints.push_back(TextOf(joint, "a joint"));
  }
  const std::string side = map.Text("knee_side");
  if (map.Find("knee_side") != nullptr && side != "plus" && side != "minus") {
    RefuseYaml(*map.Find("knee_side"), fmt::format("'knee_side' is '{}'; accepted: 'plus', 'minus'", side));
  }
  if (!side.empty()) leg.knee_sign = side == "plus" ? 1.0 : -1.0;
  return leg;
}

std::vector<MirrorPair> ParsePairs(const YAML::Node& node) {
  std::vector<MirrorPair> pairs;
  for (const YAML::Node& pair : ListOf(node, "'mirror_pairs'")) {
    const std::vector<YAML::Node> both = ListOf(pair, "a pair of 'mirror_pairs'");
    if (both.size() != 2)
      RefuseYaml(pair, fmt::format("a pair of 'mirror_pairs' has {} feet; two are needed", both.size()));
    pairs.push_back({TextOf(both[0], "a foot of a pair"), TextOf(both[1], "a foot of a pair"), LineOf(pair)});
  }
  return pairs;
}

RobotYaml::JointGains ParseGains(const YamlMap::Entry& entry) {
  const DataShape shape = GainsYamlShape();
  const YamlMap map(entry.value, fmt::format("the gains of '{}'", entry.key), shape);
  UnitKeys keys{map};
  RobotYaml::JointGains gains;
  gains.joint = entry.key;
  gains.line = LineOf(entry.key_node);
  gains.stiffness = keys.Take("stiffness_nm_rad", "stiffness_n_m");
  gains.damping = keys.Take("damping_nm_s_rad", "damping_n_s_m");
  gains.sliding = keys.Sliding(entry.key_node, fmt::format("joint '{}'", entry.key));
  return gains;
}

RobotYaml::JointLimits ParseLimits(const YamlMap::Entry& entry) {
  const DataShape shape = LimitsYamlShape();
  const YamlMap map(entry.value, fmt::format("the limits of '{}'", entry.key), shape);
  UnitKeys keys{map};
  RobotYaml::JointLimits limits;
  limits.joint = entry.key;
  limits.line = LineOf(entry.key_node);
  limits.lower = keys.Take("lower_rad", "lower_m");
  limits.upper = keys.Take("upper_rad", "upper_m");
  limits.velocity = keys.Take("velocity_rad_s", "velocity_m_s");
  limits.effort = keys.Take("effort_nm", "effort_n");
  limits.sliding = keys.Sliding(entry.key_node, fmt::format("joint '{}'", entry.key));
  return limits;
}

RobotYaml::JointMotor ParseMotor(const YamlMap::Entry& entry) {
  const DataShape shape = MotorYamlShape();
  const YamlMap map(entry.value, fmt::format("the motor of '{}'", entry.key), shape);
  UnitKeys keys{map};
  RobotYaml::JointMotor motor;
  motor.joint = entry.key;
  motor.line = LineOf(entry.key_node);
  motor.corner_speed = keys.Take("corner_velocity_rad_s", "corner_velocity_m_s");
  motor.no_load_speed = keys.Take("no_load_velocity_rad_s", "no_load_velocity_m_s");
  motor.continuous_effort = keys.Take("continuous_nm", "continuous_n");
  motor.thermal_s = map.InRange("thermal_s");
  if (motor.thermal_s && !motor.continuous_effort)
    throw InvalidArgument(
        fmt::format("line {}: the motor of '{}' has 'thermal_s', the averaging time of the continuous effort, but no "
                    "'continuous_nm' or 'continuous_n'",
                    motor.line, motor.joint));
  motor.rotor_inertia = keys.Take("rotor_inertia_kg_m2", "rotor_mass_kg");
  motor.acceleration_limit = keys.Take("acceleration_rad_s2", "acceleration_m_s2");
  motor.jerk_limit = keys.Take("jerk_rad_s3", "jerk_m_s3");
  motor.damping = keys.Take("damping_nm_s_rad", "damping_n_s_m");
  motor.friction = keys.Take("friction_nm", "friction_n");
  motor.sliding = keys.Sliding(entry.key_node, fmt::format("joint '{}'", entry.key));
  motor.has_units = keys.turning || keys.sliding;
  return motor;
}

/// Calls `each` for every entry of the map in `key`.
template <class Each>
void ForEach(const YamlMap& root, const std::string& key, Each each) {
  if (const YAML::Node* node = root.Find(key)) {
    const YamlMap map(*node, fmt::format("'{}'", key));
    for (const YamlMap::Entry& entry : map.entries()) each(entry);
  }
}

std::optional<Vector3> ParseAxis(const YamlMap& map, const std::string& key) {
  const YAML::Node* node = map.Find(key);
  if (node == nullptr) return std::nullopt;
  const std::vector<std::string>& names = AxisNames();
  const std::string text = TextOf(*node, fmt::format("'{}'", key));
  const auto at = std::find(names.begin(), names.end(), text);
  if (at == names.end()) RefuseYaml(*node, fmt::format("'{}' is '{}'; accepted: {}", key, text, QuotedList(names)));
  return AxisNamed(static_cast<int>(at - names.begin()));
}

void ParseAxes(const YamlMap& map, RobotYaml& yaml) {
  yaml.forward = ParseAxis(map, "ahead");
  yaml.up = ParseAxis(map, "up");
  if (!yaml.forward && !yaml.up) return;
  const YAML::Node& node = *map.Find(yaml.forward ? "ahead" : "up");
  if (!yaml.forward || !yaml.up) RefuseYaml(node, "'ahead' and 'up' must be given together");
  if (yaml.forward->dot(*yaml.up) != 0.0) RefuseYaml(node, "'ahead' and 'up' must be two perpendicular axes");
}

RobotYaml Parse(const YAML::Node& root) {
  RobotYaml yaml;
  if (!root || root.IsNull()) return yaml;
  const DataShape shape = RobotYamlShape();
  const YamlMap map(root, "the file", shape);
  yaml.name = map.Text("name");
  if (map.Find("name") != nullptr && yaml.name.empty()) RefuseYaml(*map.Find("name"), "'name' is empty");
  yaml.description = map.Text("description");
  yaml.scale = map.InRange("scale").value_or(1.0);
  ParseAxes(map, yaml);
  if (const YAML::Node* feet = map.Find("feet")) {
    for (const YAML::Node& foot : ListOf(*feet, "'feet'")) yaml.feet.push_back(ParseFoot(foot));
    if (yaml.feet.empty()) RefuseYaml(*feet, "'feet' is empty; leave it out to have the feet derived");
  }
  yaml.sole_give_m = map.InRange("sole_give_m");
  if (yaml.sole_give_m) yaml.sole_give_line = LineOf(*map.Find("sole_give_m"));
  if (const YAML::Node* pairs = map.Find("mirror_pairs")) yaml.mirror_pairs = ParsePairs(*pairs);
  ForEach(map, "legs", [&](const auto& entry) { yaml.legs.push_back(ParseLeg(entry)); });
  ForEach(map, "limits", [&](const auto& entry) { yaml.limits.push_back(ParseLimits(entry)); });
  ForEach(map, "gains", [&](const auto& entry) { yaml.gains.push_back(ParseGains(entry)); });
  ForEach(map, "motors", [&](const auto& entry) { yaml.motors.push_back(ParseMotor(entry)); });
  if (const YAML::Node* all = map.Find("transmissions")) yaml.transmissions = ParseTransmissions(*all);
  if (const YAML::Node* rests = map.Find("rests")) {
    for (const YAML::Node& rest : ListOf(*rests, "rests")) yaml.rests.push_back({TextOf(rest, "a rest"), LineOf(rest)});
  }
  ForEach(map, "standing", [&](const YamlMap::Entry& entry) {
    const double position =
        NumberOf(entry.value, fmt::format("the position of '{}'", entry.key), shape.At("standing").of.front());
    yaml.standing.push_back({entry.key, position, LineOf(entry.key_node)});
  });
  yaml.standing_base_height_m = map.InRange("standing_base_height_m");
  if (yaml.standing_base_height_m) yaml.height_line = LineOf(*map.Find("standing_base_height_m"));
  yaml.nominal_speed_m_s = map.InRange("nominal_speed_m_s");
  return yaml;
}

}  // namespace

RobotYaml ParseRobotYaml(const std::string& text) {
  YAML::Node root;
  try {
    root = LoadYaml(text);
  } catch (const YAML::Exception& error) {
    throw InvalidArgument(
        fmt::format("robot.yaml, line {}, column {}: this is not YAML; check for an unclosed bracket or quote, a tab, "
                    "or a wrong indent",
                    error.mark.line + 1, error.mark.column + 1));
  } catch (const InvalidArgument& error) {
    throw InvalidArgument(fmt::format("robot.yaml, {}", error.what()));
  }
  try {
    return Parse(root);
  } catch (const YAML::Exception& error) {
    RefuseYamlLine(error.mark.line + 1, "a value is of the wrong kind");
  } catch (const InvalidArgument& error) {
    throw InvalidArgument(fmt::format("robot.yaml, {}", error.what()));
  }
}

}  // namespace gaitwright
