// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "kinematics/base/strict_yaml_internal.h"
#include "playback/policy/contract_internal.h"
#include "playback/policy/observations_internal.h"

namespace gaitwright {
namespace {

bool IsNull(const YAML::Node* node) { return node == nullptr || node->IsNull(); }

std::vector<YAML::Node> SizedList(const YAML::Node& node, const std::string& what, const DataShape& shape) {
  std::vector<YAML::Node> list = ListOf(node, what);
  if (list.size() < shape.least || list.size() > shape.most)
    RefuseYaml(node, fmt::format("{} has {} entries; accepted: {} to {}", what, list.size(), shape.least, shape.most));
  return list;
}

/// Numbers, each within the range of the shape's elements.
std::vector<double> NumbersIn(const YAML::Node& node, const std::string& what, const DataShape& shape) {
  std::vector<double> numbers;
  for (const YAML::Node& one : SizedList(node, what, shape))
    numbers.push_back(NumberOf(one, fmt::format("{}[{}]", what, numbers.size()), shape.of.front()));
  return numbers;
}

/// One number, or a list; the list is the shape's second form.
std::vector<double> OneOrEachOf(const YAML::Node& node, const std::string& what, const DataShape& shape) {
  if (!node.IsSequence()) return {NumberOf(node, what, shape)};
  return NumbersIn(node, what, shape.or_else.front());
}

std::vector<int> IndicesOf(const YAML::Node& node, const std::string& what, const DataShape& shape) {
  std::vector<int> indices;
  for (const double number : NumbersIn(node, what, shape)) indices.push_back(static_cast<int>(number));
  if (std::set<int>(indices.begin(), indices.end()).size() != indices.size())
    RefuseYaml(node, fmt::format("{} has an entry twice", what));
  return indices;
}

PolicyRange RangeOf(const YAML::Node& node, const std::string& what, const DataShape& shape) {
  const std::vector<double> ends = NumbersIn(node, what, shape);
  if (ends[0] > ends[1])
    RefuseYaml(node, fmt::format("{} runs from {} to {}; the lower end comes first", what, ends[0], ends[1]));
  return {ends[0], ends[1]};
}

std::vector<std::string> NamesIn(const YAML::Node* node, const std::string& what, const DataShape& shape) {
  std::vector<std::string> names;
  if (node == nullptr) return names;
  for (const YAML::Node& one : SizedList(*node, what, shape)) names.push_back(TextOf(one, what));
  if (std::set<std::string>(names.begin(), names.end()).size() != names.size())
    RefuseYaml(*node, fmt::format("{} has a name twice", what));
  return names;
}

bool TruthOf(const YAML::Node& node, const std::string& what) {
  const std::string text = TextOf(node, what);
  if (text == "true" || text == "True") return true;
  if (text != "false" && text != "False")
    RefuseYaml(node, fmt::format("{} is '{}'; accepted: true, false", what, text));
  return false;
}

void ReadCommands(const YAML::Node& node, const DataShape& shape, PolicyContract& contract) {
  const YamlMap commands(node, "'commands'", shape);
  const YAML::Node* velocity = commands.Find("base_velocity");
  if (velocity == nullptr) return;
  const DataShape& velocity_shape = shape.At("base_velocity");
  const YamlMap base(*velocity, "'base_velocity'", velocity_shape);
  const DataShape& ranges_shape = velocity_shape.At("ranges");
  const YamlMap ranges(*base.Find("ranges"), "'ranges'", ranges_shape);
  const auto range = [&](const char* key, std::optional<PolicyRange>& target) {
    const YAML::Node* value = ranges.Find(key);
    if (!IsNull(value)) target = RangeOf(*value, key, ranges_shape.At(key));
  };
  range("lin_vel_x", contract.speed_m_s);
  range("lin_vel_y", contract.lateral_speed_m_s);
  range("ang_vel_z", contract.yaw_rate_rad_s);
}

PolicyAction ReadAction(const YAML::Node& node, const DataShape& shape) {
  const YamlMap map(node, "'JointPositionAction'", shape);
  PolicyAction action;
  if (const YAML::Node* scale = map.Find("scale"); !IsNull(scale))
    action.scale = OneOrEachOf(*scale, "the action's scale", shape.At("scale"));
  if (const YAML::Node* offset = map.Find("offset"); !IsNull(offset))
    action.offset = OneOrEachOf(*offset, "the action's offset", shape.At("offset"));
  if (const YAML::Node* clip = map.Find("clip"); !IsNull(clip)) {
    const DataShape& one = shape.At("clip");
    if (clip->IsSequence() && clip->size() > 0 && (*clip)[0].IsSequence()) {
      for (const YAML::Node& range : SizedList(*clip, "the action's clip", one.or_else.front()))
        action.clip.push_back(RangeOf(range, "the action's clip", one));
    } else {
      action.clip = {RangeOf(*clip, "the action's clip", one)};
    }
  }
  if (const YAML::Node* joints = map.Find("joint_ids"); !IsNull(joints))
    action.joints = IndicesOf(*joints, "the action's joint_ids", shape.At("joint_ids"));
  return action;
}

void ReadParameters(const YAML::Node& node, const DataShape& shape, ObservationTerm& term) {
  const YamlMap map(node, fmt::format("'params' of {}", term.name), shape);
  term.period_s = map.InRange("period");
  const YAML::Node* asset = map.Find("asset_cfg");
  if (IsNull(asset)) return;
  const YamlMap asset_map(*asset, fmt::format("'asset_cfg' of {}", term.name), shape.At("asset_cfg"));
  if (const YAML::Node* joints = asset_map.Find("joint_ids"); !IsNull(joints))
    term.joints = IndicesOf(*joints, fmt::format("joint_ids of {}", term.name), shape.At("asset_cfg").At("joint_ids"));
}

ObservationTerm ReadTerm(const YamlMap::Entry& entry, const DataShape& shape, bool scale_first) {
  const YamlMap map(entry.value, fmt::format("observation '{}'", entry.key), shape);
  ObservationTerm term;
  term.name = entry.key;
  term.scale_first = scale_first;
  if (const YAML::Node* scale = map.Find("scale"); !IsNull(scale))
    term.scale = OneOrEachOf(*scale, fmt::format("scale of {}", entry.key), shape.At("scale"));
  if (const YAML::Node* clip = map.Find("clip"); !IsNull(clip))
    term.clip = RangeOf(*clip, fmt::format("clip of {}", entry.key), shape.At("clip"));
  if (const auto history = map.InRange("history_length")) term.history = std::max(1, static_cast<int>(*history));
  if (const YAML::Node* first = map.Find("scale_first")) term.scale_first = TruthOf(*first, "scale_first");
  if (const YAML::Node* params = map.Find("params"); !IsNull(params)) ReadParameters(*params, shape.At("params"), term);
  if (entry.key == kGaitPhase && !term.period_s)
    RefuseYaml(entry.value,
               fmt::format("observation '{}' has no period; params: {{period: ...}} is needed", entry.key));
  return term;
}

void ReadObservations(const YAML::Node& node, const DataShape& shape, PolicyContract& contract) {
  const YamlMap map(node, "'observations'", shape);
  const YAML::Node* first = map.Find("scale_first");
  const bool scale_first = first != nullptr && TruthOf(*first, "scale_first");
  for (const YamlMap::Entry& entry : map.entries()) {
    if (entry.key == "use_gym_history") contract.history_by_frame = TruthOf(entry.value, entry.key);
    if (entry.key == "use_gym_history" || entry.key == "scale_first") continue;
    contract.observations.push_back(ReadTerm(entry, shape.At(entry.key), scale_first));
  }
  if (contract.observations.empty()) RefuseYaml(node, "'observations' names no observation");
  const int history = contract.observations.front().history;
  for (const ObservationTerm& term : contract.observations) {
    if (contract.history_by_frame && term.history != history)
      RefuseYaml(node, fmt::format("use_gym_history needs one history_length; '{}' has {}, '{}' has {}",
                                   contract.observations.front().name, history, term.name, term.history));
  }
}

/// Refuses lists whose sizes contradict each other.
void CheckSizes(const YAML::Node& root, const PolicyContract& c) {
  const auto needs = [&](const char* what, std::size_t count, std::size_t needed) {
    if (count != needed)
      RefuseYaml(root, fmt::format("'{}' has {} entries; 'default_joint_pos' has {}", what, count, needed));
  };
  const std::size_t n = c.default_position.size();
  if (!c.joint_names.empty()) needs("joint_names", c.joint_names.size(), n);
  if (!c.joint_ids_map.empty()) needs("joint_ids_map", c.joint_ids_map.size(), n);
  const int last = c.joint_ids_map.empty() ? static_cast<int>(n) - 1
                                           : *std::max_element(c.joint_ids_map.begin(), c.joint_ids_map.end());
  const auto of_hardware = [&](const char* what, std::size_t count) {
    if (count != n && static_cast<int>(count) <= last)
      RefuseYaml(root,
                 fmt::format("'{}' has {} entries; {} joints or all {} motors are needed", what, count, n, last + 1));
  };
  of_hardware("stiffness", c.stiffness.size());
  if (c.damping.size() != c.stiffness.size())
    RefuseYaml(root, fmt::format("'damping' has {} entries; 'stiffness' has {}", c.damping.size(), c.stiffness.size()));
  if (!c.hardware_names.empty() && c.hardware_names.size() != c.stiffness.size())
    RefuseYaml(root, fmt::format("'joint_sdk_names' has {} entries; 'stiffness' has {}", c.hardware_names.size(),
                                 c.stiffness.size()));
}

PolicyContract ReadRoot(const YAML::Node& root) {
  const DataShape shape = ContractShape();
  const YamlMap map(root, "the contract", shape);
  const auto numbers = [&](const char* key) { return NumbersIn(*map.Find(key), key, shape.At(key)); };
  PolicyContract contract;
  contract.step_s = map.InRange("step_dt").value();
  contract.joint_names = NamesIn(map.Find("joint_names"), "joint_names", shape.At("joint_names"));
  contract.hardware_names = NamesIn(map.Find("joint_sdk_names"), "joint_sdk_names", shape.At("joint_sdk_names"));
  if (const YAML::Node* ids = map.Find("joint_ids_map"))
    contract.joint_ids_map = IndicesOf(*ids, "joint_ids_map", shape.At("joint_ids_map"));
  contract.stiffness = numbers("stiffness");
  contract.damping = numbers("damping");
  contract.default_position = numbers("default_joint_pos");
  if (const YAML::Node* commands = map.Find("commands"); !IsNull(commands))
    ReadCommands(*commands, shape.At("commands"), contract);
  const DataShape& actions_shape = shape.At("actions");
  const YamlMap actions(*map.Find("actions"), "'actions'", actions_shape);
  contract.action = ReadAction(*actions.Find("JointPositionAction"), actions_shape.At("JointPositionAction"));
  ReadObservations(*map.Find("observations"), shape.At("observations"), contract);
  CheckSizes(root, contract);
  return contract;
}

}  // namespace

int PolicyContract::HardwareIndex(int joint) const {
  if (joint_ids_map.empty()) return joint;
  const int id = joint_ids_map[static_cast<std::size_t>(joint)];
  if (stiffness.size() != joint_ids_map.size()) return id;
  return static_cast<int>(
      std::count_if(joint_ids_map.begin(), joint_ids_map.end(), [&](int other) { return other < id; }));
}

Result<PolicyContract> ReadContract(const std::string& text, const std::string& source) {
  const auto bad = [&](const std::string& message) {
    return Failure{FailureKind::kBadInput,
                   FailureCode::kOptionsFile,
                   "ReadContract",
                   fmt::format("'{}', {}", source, message),
                   {"docs/policies.md lists all keys and observations"}};
  };
  try {
    const YAML::Node root = LoadYaml(text);
    if (!root.IsMap()) return bad("line 1: contains no contract; a map of keys is needed");
    return ReadRoot(root);
  } catch (const YAML::Exception& error) {
    return bad(fmt::format("line {}: not valid YAML from here on", error.mark.line + 1));
  } catch (const InvalidArgument& error) {
    return bad(error.what());
  }
}

}  // namespace gaitwright
