// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "kinematics/base/nearest_name.h"
#include "kinematics/base/result.h"
#include "kinematics/base/strict_yaml_internal.h"
#include "kinematics/base/text.h"

namespace gaitwright {

const char* KindOf(const YAML::Node& node) {
  switch (node.Type()) {
    case YAML::NodeType::Sequence:
      return "a list";
    case YAML::NodeType::Map:
      return "a map";
    case YAML::NodeType::Null:
      return "empty";
    default:
      return "a single value";
  }
}

int LineOf(const YAML::Node& node) { return std::max(node.Mark().line, 0) + 1; }

void RefuseYaml(const YAML::Node& node, const std::string& message) {
  throw InvalidArgument(fmt::format("line {}: {}", LineOf(node), message));
}

std::string TextOf(const YAML::Node& node, const std::string& what) {
  if (!node.IsScalar()) RefuseYaml(node, fmt::format("{} is {}; one word or text is needed", what, KindOf(node)));
  if (!IsPlainText(node.Scalar())) RefuseYaml(node, what + " contains a control character or is not valid UTF-8");
  return node.Scalar();
}

double NumberOf(const YAML::Node& node, const std::string& what) {
  const std::string text = TextOf(node, what);
  double value = 0.0;
  if (!YAML::convert<double>::decode(node, value))
    RefuseYaml(node, fmt::format("{} is '{}'; a number is needed", what, text));
  if (!std::isfinite(value)) RefuseYaml(node, fmt::format("{} is {}; a finite number is needed", what, value));
  return value;
}

double NumberOf(const YAML::Node& node, const std::string& what, double low, double high) {
  const double value = NumberOf(node, what);
  if (value < low || value > high)
    RefuseYaml(node, fmt::format("{} is {}; accepted: {} to {}", what, value, low, high));
  return value;
}

double NumberOf(const YAML::Node& node, const std::string& what, const DataShape& shape) {
  const double value = NumberOf(node, what);
  if (shape.over_lowest) {
    if (value <= shape.lowest) RefuseYaml(node, fmt::format("{} is {}; it must be above 0", what, value));
    if (value > shape.highest)
      RefuseYaml(node, fmt::format("{} is {}; at most {} is accepted", what, value, shape.highest));
  } else {
    NumberOf(node, what, shape.lowest, shape.highest);
  }
  if (shape.kind == DataShape::Kind::kWhole && value != std::floor(value))
    RefuseYaml(node, fmt::format("{} is {}; a whole number is needed", what, value));
  return value;
}

std::vector<YAML::Node> ListOf(const YAML::Node& node, const std::string& what) {
  if (!node.IsSequence()) RefuseYaml(node, fmt::format("{} is {}; a list is needed", what, KindOf(node)));
  return {node.begin(), node.end()};
}

YamlMap::YamlMap(const YAML::Node& node, const std::string& what, const std::vector<std::string>& known)
    : node_(node), what_(what) {
  if (!node.IsMap()) RefuseYaml(node, fmt::format("{} is {}; a map of keys is needed", what, KindOf(node)));
  std::set<std::string> seen;
  for (const auto& entry : node) {
    const std::string key = TextOf(entry.first, "a key of " + what);
    if (!seen.insert(key).second) RefuseYaml(entry.first, fmt::format("{} has the key '{}' twice", what, key));
    if (!known.empty() && std::find(known.begin(), known.end(), key) == known.end()) {
      RefuseYaml(entry.first, fmt::format("{} has the unknown key '{}'{}", what, key, NearestOrAll(key, known)));
    }
    entries_.push_back({key, entry.first, entry.second});
  }
}

YamlMap::YamlMap(const YAML::Node& node, const std::string& what, const DataShape& shape)
    : YamlMap(node, what, shape.Keys()) {
  shape_ = &shape;
  Require(shape.NeededKeys());
}

void YamlMap::Require(const std::vector<std::string>& needed) const {
  for (const std::string& key : needed) {
    if (Find(key) == nullptr) RefuseYaml(node_, fmt::format("{} lacks the key '{}'", what_, key));
  }
}

const YAML::Node* YamlMap::Find(const std::string& key) const {
  const auto at = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& entry) { return entry.key == key; });
  return at == entries_.end() ? nullptr : &at->value;
}

std::string YamlMap::Text(const std::string& key) const {
  const YAML::Node* node = Find(key);
  return node == nullptr ? "" : TextOf(*node, fmt::format("'{}'", key));
}

std::optional<double> YamlMap::Number(const std::string& key) const {
  const YAML::Node* node = Find(key);
  if (node == nullptr) return std::nullopt;
  return NumberOf(*node, fmt::format("'{}'", key));
}

std::optional<double> YamlMap::Positive(const std::string& key) const {
  const std::optional<double> value = Number(key);
  if (value && *value <= 0.0) {
    RefuseYaml(*Find(key), fmt::format("'{}' is {}; it must be above 0", key, *value));
  }
  return value;
}

std::optional<double> YamlMap::InRange(const std::string& key) const {
  const YAML::Node* node = Find(key);
  if (node == nullptr) return std::nullopt;
  return NumberOf(*node, fmt::format("'{}'", key), shape_->At(key));
}

}  // namespace gaitwright
