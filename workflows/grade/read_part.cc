// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "kinematics/base/nearest_name.h"
#include "kinematics/model/load_robot.h"
#include "planning/gait/find_gait.h"
#include "planning/terrain/load_terrain.h"
#include "playback/score/gates.h"
#include "workflows/grade/motion_measures.h"
#include "workflows/grade/questions.h"
#include "workflows/grade/read_part_internal.h"
#include "workflows/grade/rubric_shape.h"
#include "workflows/study/run_point.h"
#include "workflows/study/trial.h"
#include "workflows/walk/walk.h"

namespace gaitwright {
namespace {

void ReadWhole(const YamlMap& map, const std::string& key, int& target) {
  if (const std::optional<double> value = map.InRange(key)) target = static_cast<int>(*value);
}

void ReadNumber(const YamlMap& map, const std::string& key, double& target) {
  if (const std::optional<double> value = map.InRange(key)) target = *value;
}

NamedRanges RangesAt(const YAML::Node& node, const std::string& what, const std::vector<std::string>& known) {
  NamedRanges ranges;
  const YamlMap map(node, what, known);
  for (const YamlMap::Entry& entry : map.entries())
    ranges.emplace_back(entry.key, RangeAt(entry.value, fmt::format("'{}'", entry.key)));
  return ranges;
}

std::string RobotAt(const YamlMap& map) {
  const YAML::Node* node = map.Find("robot");
  if (node == nullptr) return "";
  std::string name = TextOf(*node, "'robot'");
  const std::vector<std::string> names = RobotNames();
  if (std::find(names.begin(), names.end(), name) == names.end())
    RefuseYaml(*node, fmt::format("there is no robot '{}'{}", name, NearestOrAll(name, names)));
  return name;
}

void ReadTerrain(const YAML::Node& node, MotionSetup& motion) {
  if (node.IsMap()) {
    const YamlMap map(node, "'terrain'");
    map.Require({"name"});
    motion.terrain = map.Text("name");
    for (const YamlMap::Entry& entry : map.entries()) {
      if (entry.key != "name")
        motion.terrain_parameters.emplace_back(entry.key, RangeAt(entry.value, fmt::format("'{}'", entry.key)));
    }
  } else {
    motion.terrain = TextOf(node, "'terrain'");
  }
  if (!TerrainFileOf(motion.terrain).empty())
    RefuseYaml(node, fmt::format("'{}' is a file; a rubric accepts built-in grounds only, see 'gaitwright terrains'",
                                 motion.terrain));
}

void ReadPlay(const YAML::Node& node, MotionSetup& motion) {
  PlayRequest request;
  OptionFields fields = request.Fields();
  const YamlMap map(node, "'play'");
  for (const YamlMap::Entry& entry : map.entries()) {
    try {
      if (entry.value.IsSequence()) {
        const NumberRange range = RangeAt(entry.value, fmt::format("'{}'", entry.key));
        for (const double end : {range.low, range.high}) SetOption(fields, entry.key, fmt::format("{}", end));
        motion.play_numbers.emplace_back(entry.key, range);
      } else {
        const std::string text = TextOf(entry.value, fmt::format("'{}'", entry.key));
        SetOption(fields, entry.key, text);
        motion.play_words.emplace_back(entry.key, text);
      }
    } catch (const InvalidArgument& error) {
      const std::string why = error.what();
      why.starts_with("line ") ? throw error : RefuseYaml(entry.value, why);
    }
  }
}

void ReadDisturbancesOf(const YAML::Node& node, MotionSetup& motion) {
  if (node.IsScalar()) {
    const std::string word = TextOf(node, "'disturbances'");
    if (word != "standard")
      RefuseYaml(node,
                 fmt::format("'disturbances' is '{}'; accepted: 'standard', or a map as in docs/trials.md", word));
    return;
  }
  PlayRequest request;
  const Result<Disturbances> read = ReadDisturbances(YAML::Dump(node), SensorFields(request), "disturbances");
  if (!read) RefuseYaml(node, read.failure().message);
  motion.disturbances = *read;
}

void ReadOptions(const YAML::Node& node, MotionSetup& motion) {
  WalkRequest walk;
  const OptionFields fields = walk.Fields();
  for (const YAML::Node& one : ListOf(node, "'options'")) {
    const std::string key = TextOf(one, "an option");
    std::vector<std::string> known;
    bool found = false;
    for (const OptionField& field : fields) {
      known.push_back(field.key);
      found = found || MayBeSet(field.key, {key});
    }
    if (!found) RefuseYaml(one, fmt::format("there is no plan option '{}'{}", key, NearestHint(key, known)));
    motion.options.push_back(key);
  }
}

/// Checks that the command has the extent or the goal that the kind of part needs.
void CheckCommandOf(const YamlMap& map, const YAML::Node& node, const RubricPart& part) {
  const NamedRanges& command = part.motion.command;
  const auto has = [&](const std::string& key) {
    return std::any_of(command.begin(), command.end(), [&](const auto& one) { return one.first == key; });
  };
  const bool goal = has("goal_x_m") || has("goal_y_m") || has("goal_yaw_rad");
  if (part.kind == RubricPartKind::kPlanner && !goal)
    RefuseYaml(node,
               fmt::format("part '{}' lacks a goal: its 'command' needs goal_x_m, goal_y_m, goal_yaw_rad", part.name));
  const bool steps_only = goal || command.empty();
  if ((part.kind == RubricPartKind::kPlanner || part.kind == RubricPartKind::kMotion) && !steps_only)
    RefuseYaml(
        *map.Find("command"),
        fmt::format("part '{}' is marked by its end pose: its 'command' accepts only goal_x_m, goal_y_m, goal_yaw_rad",
                    part.name));
}

}  // namespace

NumberRange RangeAt(const YAML::Node& node, const std::string& what) {
  if (!node.IsSequence()) {
    const double value = NumberOf(node, what);
    return {value, value};
  }
  const std::vector<YAML::Node> ends = ListOf(node, what);
  if (ends.size() != 2)
    RefuseYaml(node, fmt::format("{} has {} numbers; accepted: one, or [lowest, highest]", what, ends.size()));
  const NumberRange range{NumberOf(ends[0], what), NumberOf(ends[1], what)};
  if (range.low > range.high)
    RefuseYaml(node, fmt::format("{} is drawn from {} to {}; the first must be below the second", what, range.low,
                                 range.high));
  return range;
}

MeasureRule MeasureAt(const YAML::Node& node, const std::string& measure, RubricPartKind kind) {
  const std::vector<std::string> names = MeasuresOf(kind);
  if (std::find(names.begin(), names.end(), measure) == names.end())
    RefuseYaml(node, fmt::format("there is no measure '{}'{}", measure,
                                 NearestOrAll(measure, names, "docs/grading.md lists all of them")));
  if (measure == "share_right") return {true, 1.0};
  if (measure == "largest_error") return {false, {}};
  return PlaysMotions(kind) ? RuleOfMeasure(measure) : MeasureRule{};
}

void ReadQuestionSetup(const YamlMap& map, const YAML::Node& node, RubricPart& part) {
  QuestionSetup& question = part.question;
  question.reference = map.Text("reference");
  const std::vector<std::string> names = QuestionNames();
  if (std::find(names.begin(), names.end(), question.reference) == names.end())
    RefuseYaml(*map.Find("reference"),
               fmt::format("there is no reference '{}'{}", question.reference,
                           NearestOrAll(question.reference, names, "docs/grading.md lists all")));
  const Question& asked = QuestionOf(question.reference);
  ReadWhole(map, "cases", question.cases);
  ReadWhole(map, "size", question.size);
  ReadNumber(map, "tolerance", question.tolerance);
  question.robot = RobotAt(map);
  if (asked.needs_robot && question.robot.empty())
    RefuseYaml(node, fmt::format("part '{}' lacks the key 'robot', which '{}' needs", part.name, asked.name));
  std::vector<std::string> inputs;
  for (const QuestionInput& input : asked.inputs) inputs.push_back(input.name);
  if (const YAML::Node* ranges = map.Find("inputs")) question.inputs = RangesAt(*ranges, "'inputs'", inputs);
  if (part.kind == RubricPartKind::kAnswers && map.Find("seed") != nullptr)
    question.seed = static_cast<std::uint64_t>(*map.InRange("seed"));
}

void ReadGait(const YamlMap& map, MotionSetup& motion) {
  motion.gait = map.Text("gait");
  if (motion.gait.empty() || motion.robot.empty()) return;
  const Result<RobotModel> model = LoadNamedRobot(motion.robot);
  if (!model) return;  // refused elsewhere
  const Result<Gait> gait = FindGait(*model, motion.gait, model->nominal_speed_m_s, GaitOptions{});
  if (!gait) RefuseYaml(*map.Find("gait"), gait.failure().message);
}

void ReadMotionSetup(const YamlMap& map, const YAML::Node& node, RubricPart& part) {
  MotionSetup& motion = part.motion;
  motion.robot = RobotAt(map);
  ReadGait(map, motion);
  if (const YAML::Node* terrain = map.Find("terrain")) ReadTerrain(*terrain, motion);
  if (const YAML::Node* command = map.Find("command")) motion.command = RangesAt(*command, "'command'", CommandKeys());
  ReadWhole(map, "runs", motion.runs);
  ReadWhole(map, "trials", motion.trials);
  ReadNumber(map, "swing_s", motion.swing_s);
  ReadNumber(map, "pause_s", motion.pause_s);
  if (const YAML::Node* play = map.Find("play")) ReadPlay(*play, motion);
  if (const YAML::Node* drawn = map.Find("disturbances")) ReadDisturbancesOf(*drawn, motion);
  if (const YAML::Node* options = map.Find("options")) ReadOptions(*options, motion);
  if (const YAML::Node* controller = map.Find("controller")) {
    motion.controller = TextOf(*controller, "'controller'");
    const std::vector<std::string>& names = ControllerNames();
    if (std::find(names.begin(), names.end(), motion.controller) == names.end())
      RefuseYaml(*controller, fmt::format("there is no controller '{}'{}", motion.controller,
                                          NearestOrAll(motion.controller, names)));
  }
  CheckCommandOf(map, node, part);
}

void ReadCodeSetup(const YamlMap& map, RubricPart& part) {
  part.package = part.kind != RubricPartKind::kFunction;
  if (const YAML::Node* package = map.Find("package")) {
    if (!YAML::convert<bool>::decode(*package, part.package))
      RefuseYaml(*package, fmt::format("'package' is '{}'; accepted: true, false", TextOf(*package, "'package'")));
  }
  part.function = map.Text("function");
  if (!part.function.empty()) return;
  part.function = part.kind == RubricPartKind::kPlanner      ? "plan_steps"
                  : part.kind == RubricPartKind::kController ? "make_controller"
                                                             : part.question.reference;
}

}  // namespace gaitwright
