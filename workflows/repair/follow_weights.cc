// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "kinematics/base/strict_yaml_internal.h"
#include "kinematics/dynamics/dynamics.h"
#include "kinematics/model/upper_body.h"
#include "workflows/repair/follow_weights_internal.h"
#include "workflows/repair/joint_groups_internal.h"

namespace gaitwright {
namespace {

constexpr double kLargestWeight = 1e4, kLatest = 1e5;

struct WeightGroup {
  const char* key;
  const char* meaning;
};

constexpr WeightGroup kWeightGroups[] = {
    {"legs", "Factor of repair.joint for the joints of the legs."},
    {"arms", "Factor of repair.joint for the joints of the arms."},
    {"torso", "Factor of repair.joint for joints of neither legs, arms nor head."},
    {"head", "Factor of repair.joint for the joints of the head."},
    {"base_position", "Factor of repair.base_position."},
    {"base_orientation", "Factor of repair.base_rotation."},
    {"hands", "Weight on the distance of the ends of the arms; default 0 [1/m]."},
};

std::vector<ShapeMember> GroupMembers() {
  std::vector<ShapeMember> members;
  for (const WeightGroup& group : kWeightGroups)
    members.push_back(shapes::Optional(group.key, shapes::Number(0.0, kLargestWeight), group.meaning));
  return members;
}

/// The groups that a robot has.
std::vector<std::string> GroupsOf(const RobotModel& model) {
  const UpperBody upper = FindUpperBody(model);
  const std::vector<std::string> of_joints = GroupsOfJoints(model, upper);
  std::vector<std::string> groups;
  for (const WeightGroup& group : kWeightGroups) {
    const std::string key = group.key;
    const bool of_base = key.starts_with("base"), of_hands = key == "hands" && (upper.left_arm || upper.right_arm);
    if (of_base || of_hands || std::find(of_joints.begin(), of_joints.end(), key) != of_joints.end())
      groups.push_back(key);
  }
  return groups;
}

WeightRange RangeOf(const YamlMap& map, const std::vector<std::string>& known, const std::string& robot) {
  WeightRange range;
  for (const YamlMap::Entry& entry : map.entries()) {
    if (entry.key == "start_s" || entry.key == "end_s") continue;
    if (std::find(known.begin(), known.end(), entry.key) == known.end())
      RefuseYaml(entry.key_node,
                 fmt::format("robot '{}' has no {}; its groups: {}", robot, entry.key, fmt::join(known, ", ")));
    range.of[entry.key] = *map.InRange(entry.key);
  }
  range.start_s = map.InRange("start_s").value_or(range.start_s);
  range.end_s = map.InRange("end_s").value_or(range.end_s);
  return range;
}

/// Refuses feet with the reason, and other unknown groups with the list of all groups.
void CheckGroups(const YAML::Node& node) {
  if (!node.IsMap()) return;
  std::vector<std::string> all;
  for (const WeightGroup& group : kWeightGroups) all.emplace_back(group.key);
  for (const auto& entry : node) {
    const std::string key = TextOf(entry.first, "a group");
    if (key == "start_s" || key == "end_s" || std::find(all.begin(), all.end(), key) != all.end()) continue;
    const std::string why =
        key == "feet" ? "feet have no weight, because they follow the clean contacts and swings exactly" : "";
    RefuseYaml(entry.first, fmt::format("{}; groups: {}", why.empty() ? fmt::format("unknown group '{}'", key) : why,
                                        fmt::join(all, ", ")));
  }
}

FollowWeights WeightsOf(const RobotModel& model, const YAML::Node& root) {
  const DataShape shape = FollowWeightsShape();
  const YamlMap map(root, "the weights", shape);
  const std::vector<std::string> known = GroupsOf(model);
  FollowWeights weights;
  if (const YAML::Node* always = map.Find("always")) {
    CheckGroups(*always);
    weights.ranges.push_back(RangeOf(YamlMap(*always, "always", shape.At("always")), known, model.name));
  }
  if (const YAML::Node* during = map.Find("during")) {
    for (const YAML::Node& node : ListOf(*during, "during")) {
      CheckGroups(node);
      weights.ranges.push_back(RangeOf(YamlMap(node, "a range", shape.At("during").of.front()), known, model.name));
      const WeightRange& range = weights.ranges.back();
      if (!(range.end_s > range.start_s))
        RefuseYaml(node, fmt::format("end_s is {} and start_s {}; the end must be later", range.end_s, range.start_s));
    }
  }
  if (const std::string in = map.Text("hands_in"); !in.empty()) {
    const std::vector<std::string>& choices = shape.At("hands_in").choices;
    if (std::find(choices.begin(), choices.end(), in) == choices.end())
      RefuseYaml(*map.Find("hands_in"), fmt::format("hands_in is '{}'; accepted: {}", in, fmt::join(choices, ", ")));
    weights.hands_in_base = in == "base";
  }
  return weights;
}

}  // namespace

double FollowWeights::Of(const std::string& group, double time_s, double otherwise) const {
  const auto last = std::find_if(ranges.rbegin(), ranges.rend(), [&](const auto& range) {
    return time_s >= range.start_s && time_s <= range.end_s && range.of.contains(group);
  });
  return last == ranges.rend() ? otherwise : last->of.at(group);
}

DataShape FollowWeightsShape() {
  using namespace shapes;
  std::vector<ShapeMember> timed = {{"start_s", Number(0.0, kLatest), "Start, in the file's time [s]."},
                                    {"end_s", Number(0.0, kLatest), "End, in the file's time [s]."}};
  for (ShapeMember& member : GroupMembers()) timed.push_back(std::move(member));
  return Object({Optional("always", Object(GroupMembers()), "Weights at all times outside the ranges."),
                 Optional("during", List(Object(std::move(timed)), 1),
                          "Weights over ranges of time; where ranges overlap, the last one is used."),
                 Optional("hands_in", Text({"world", "base"}),
                          "Where hands are compared: in the world (default), or relative to the base.")});
}

Result<FollowWeights> ReadFollowWeights(const RobotModel& model, const std::string& text, const std::string& source) {
  const auto bad = [&](const std::string& message) {
    return Failure{FailureKind::kBadInput,
                   FailureCode::kOptionsFile,
                   "ReadFollowWeights",
                   fmt::format("'{}': {}", source, message),
                   {"docs/repair.md describes the file of weights"}};
  };
  try {
    return WeightsOf(model, LoadYaml(text));
  } catch (const YAML::Exception& error) {
    return bad(fmt::format("line {}: not valid YAML from here on", error.mark.line + 1));
  } catch (const InvalidArgument& error) {
    return bad(error.what());
  }
}

void SetWeights(const FollowWeights& weights, const std::vector<double>& file_s, BodyProblem& problem) {
  const RobotModel& model = *problem.model;
  const UpperBody upper = FindUpperBody(model);
  const std::vector<std::string> groups = GroupsOfJoints(model, upper);
  DynamicsScratch scratch(model);
  ChartedState state;
  for (std::size_t k = 0; k < problem.knots.size(); ++k) {
    BodyKnot& knot = problem.knots[k];
    const auto of = [&](const std::string& group, double otherwise) { return weights.Of(group, file_s[k], otherwise); };
    knot.near_scale = VectorX::Ones(model.nv());
    knot.near_scale.head<3>().setConstant(of("base_position", 1.0));
    knot.near_scale.segment<3>(3).setConstant(of("base_orientation", 1.0));
    for (int dof = 0; dof < model.num_dofs(); ++dof)
      knot.near_scale[6 + dof] = of(groups[static_cast<std::size_t>(dof)], 1.0);
    const double hands = of("hands", 0.0);
    knot.points.clear();
    if (hands == 0.0) continue;
    StateOf(problem.chart, knot.reference, state);
    ForwardKinematics(model, state.q, scratch);
    for (const std::optional<Limb>* arm : {&upper.left_arm, &upper.right_arm}) {
      if (!*arm) continue;
      PointGoal goal{(*arm)->end_body, (*arm)->p_BE, Vector3::Zero(), weights.hands_in_base, hands};
      const auto body = static_cast<std::size_t>(goal.body);
      goal.p_W = scratch.p_WB[body] + scratch.R_WB[body] * goal.p_BQ;
      if (goal.in_base) goal.p_W = (scratch.R_WB[0].transpose() * (goal.p_W - scratch.p_WB[0])).eval();
      knot.points.push_back(goal);
    }
  }
}

}  // namespace gaitwright
