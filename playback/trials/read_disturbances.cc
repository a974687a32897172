// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <nlohmann/json.hpp>

#include "kinematics/base/file.h"
#include "kinematics/base/strict_yaml_internal.h"
#include "playback/trials/disturbances.h"
#include "playback/trials/disturbances_shape.h"

namespace gaitwright {
namespace {

constexpr std::size_t kMostPushes = 100;
constexpr double kBellReach = 3.0;  // standard deviations to the default limits of a normal distribution
constexpr char kPlace[] = "place";
const std::vector<std::string> kKinds = {"uniform", "normal", "choice", "fixed"};

/// Calls a function that throws without a line number, and adds the line of `node`.
template <class Make>
auto At(const YAML::Node& node, Make make) {
  try {
    return make();
  } catch (const InvalidArgument& error) {
    RefuseYaml(node, error.what());
  }
}

/// Reads a value and checks it against the rule.
double ValueOf(const YAML::Node& node, const DisturbanceRule& rule) {
  const double value = NumberOf(node, rule.key, rule.lowest, rule.highest);
  if (rule.whole && value != std::round(value))
    RefuseYaml(node, fmt::format("{} is {}; a whole number is needed", rule.key, value));
  return value;
}

DataShape ValueShape(const DisturbanceRule& rule) {
  return rule.whole ? shapes::Whole(rule.lowest, rule.highest) : shapes::Number(rule.lowest, rule.highest);
}

DataShape NormalShape(const DisturbanceRule& rule) {
  using namespace shapes;
  return Object({{"mean", Number()},
                 {"std", Positive()},
                 Optional("lowest", ValueShape(rule), "Lower limit; default: three std below the mean."),
                 Optional("highest", ValueShape(rule), "Upper limit; default: three std above the mean.")});
}

/// Shape of a value or a distribution.
ShapeMember DistributionShape(const DisturbanceRule& rule) {
  using namespace shapes;
  const bool words = rule.key == kPlace;
  const DataShape value = words ? Text() : ValueShape(rule);
  const DataShape choice = List(value, 1);
  const DataShape drawn = words ? Object({Optional("choice", choice), Optional("fixed", value)}, {{"choice", "fixed"}})
                                : Object({Optional("uniform", List(value, 2, 2)), Optional("normal", NormalShape(rule)),
                                          Optional("choice", choice), Optional("fixed", value)},
                                         {kKinds});
  const bool bare = rule.unit.empty() || rule.unit == "1";
  return {rule.key, Either(value, drawn), bare ? rule.meaning : fmt::format("{} [{}]", rule.meaning, rule.unit), false};
}

DataShape FiguresShape(const std::vector<DisturbanceRule>& rules) {
  DataShape shape = shapes::Object({});
  for (const DisturbanceRule& rule : rules) shape.members.push_back(DistributionShape(rule));
  return shape;
}

Distribution ReadUniform(const YAML::Node& node, const DisturbanceRule& rule) {
  const std::vector<YAML::Node> ends = ListOf(node, "'uniform' of " + rule.key);
  if (ends.size() != 2)
    RefuseYaml(node, fmt::format("'uniform' of {} has {} numbers; 2 are needed, [a, b]", rule.key, ends.size()));
  const double low = ValueOf(ends[0], rule), high = ValueOf(ends[1], rule);
  return At(node, [&] { return Distribution::Uniform(low, high); });
}

Distribution ReadNormal(const YAML::Node& node, const DisturbanceRule& rule) {
  const DataShape shape = NormalShape(rule);
  const YamlMap map(node, "'normal' of " + rule.key, shape);
  const double mean = map.Number("mean").value(), std = map.Positive("std").value();
  const auto limit = [&](const char* key, double otherwise) {
    const YAML::Node* own = map.Find(key);
    return own == nullptr ? std::clamp(otherwise, rule.lowest, rule.highest)
                          : NumberOf(*own, rule.key + "." + key, rule.lowest, rule.highest);
  };
  const double low = limit("lowest", mean - kBellReach * std), high = limit("highest", mean + kBellReach * std);
  return At(node, [&] { return Distribution::Normal(mean, std, low, high); });
}

Distribution ReadChoice(const YAML::Node& node, const DisturbanceRule& rule, bool words) {
  std::vector<double> numbers;
  std::vector<std::string> texts;
  for (const YAML::Node& one : ListOf(node, "'choice' of " + rule.key)) {
    words ? texts.push_back(TextOf(one, rule.key)) : numbers.push_back(ValueOf(one, rule));
  }
  return At(node, [&] { return words ? Distribution::OneOf(texts) : Distribution::OneOf(numbers); });
}

/// Reads a distribution; a plain value is a fixed one.
Distribution ReadDistribution(const YAML::Node& node, const DisturbanceRule& rule) {
  const bool words = rule.key == kPlace;
  const auto fixed = [&](const YAML::Node& value) {
    return words ? Distribution::OneOf({TextOf(value, rule.key)}) : Distribution::Fixed(ValueOf(value, rule));
  };
  if (node.IsScalar()) return fixed(node);
  const YamlMap map(node, fmt::format("the distribution of '{}'", rule.key), kKinds);
  if (map.entries().size() != 1) {
    RefuseYaml(node, fmt::format("the distribution of '{}' has {} keys; give exactly one of {}", rule.key,
                                 map.entries().size(), QuotedList(kKinds)));
  }
  const auto& [kind, key_node, value] = map.entries().front();
  if (words && kind != "choice" && kind != "fixed")
    RefuseYaml(key_node, fmt::format("'{}' is '{}'; words are needed, 'choice' or 'fixed'", rule.key, kind));
  if (kind == "uniform") return ReadUniform(value, rule);
  if (kind == "normal") return ReadNormal(value, rule);
  if (kind == "choice") return ReadChoice(value, rule, words);
  return fixed(value);
}

/// Reads the quantities of a map, each by the rule of its key.
std::vector<Disturbance> ReadFigures(const YAML::Node& node, const std::string& what, const std::string& before,
                                     const std::vector<DisturbanceRule>& rules) {
  std::vector<Disturbance> figures;
  const DataShape shape = FiguresShape(rules);
  const YamlMap map(node, what, shape);
  for (const auto& entry : map.entries()) {
    const auto rule = std::find_if(rules.begin(), rules.end(), [&](const auto& r) { return r.key == entry.key; });
    DisturbanceRule named = *rule;
    named.key = before + rule->key;
    figures.push_back({named.key, ReadDistribution(entry.value, before.empty() ? *rule : named)});
  }
  return figures;
}

void NotBoth(const YAML::Node& node, const std::vector<Disturbance>& figures, const char* one, const char* other) {
  if (HasFigure(figures, one) && HasFigure(figures, other))
    RefuseYaml(node, fmt::format("'{}' and '{}' are both given, but set the same value; give only one", one, other));
}

DisturbedPush ReadPush(const YAML::Node& node) {
  DisturbedPush push = ReadFigures(node, "a push", "", PushRules());
  NotBoth(node, push, "size_n", "size_of_weight");
  NotBoth(node, push, "at_s", "at_share");
  if (!HasFigure(push, "size_n") && !HasFigure(push, "size_of_weight"))
    RefuseYaml(node, "a push has no size; 'size_n' or 'size_of_weight' is needed");
  return push;
}

/// The rules of keys without a group, or of keys that begin with `group`, without the group.
std::vector<DisturbanceRule> RulesOf(const std::string& group) {
  std::vector<DisturbanceRule> rules;
  for (DisturbanceRule rule : DisturbanceRules()) {
    const std::size_t dot = rule.key.find('.');
    if ((dot == std::string::npos ? "" : rule.key.substr(0, dot)) != group) continue;
    if (dot != std::string::npos) rule.key.erase(0, dot + 1);
    rules.push_back(rule);
  }
  return rules;
}

std::vector<DisturbanceRule> SensorRules(const OptionFields& sensors) {
  std::vector<DisturbanceRule> rules;
  for (const OptionField& field : sensors) {
    if (field.key == "seed" || !std::holds_alternative<double*>(field.target)) continue;
    rules.push_back({field.key, "sensors." + field.key, field.unit, field.lowest, field.highest, field.meaning});
  }
  return rules;
}

Disturbances ReadRoot(const YAML::Node& root, const OptionFields& sensors) {
  const std::vector<DisturbanceRule> own = RulesOf("");
  const DataShape shape = DisturbancesShape(sensors);
  Disturbances disturbances;
  const auto add = [&](const std::vector<Disturbance>& figures) {
    disturbances.figures.insert(disturbances.figures.end(), figures.begin(), figures.end());
  };
  const YamlMap map(root, "the file", shape);
  for (const auto& entry : map.entries()) {
    if (entry.key == "start") {
      add(ReadFigures(entry.value, "'start'", "start.", RulesOf("start")));
    } else if (entry.key == "sensors") {
      add(ReadFigures(entry.value, "'sensors'", "sensors.", SensorRules(sensors)));
    } else if (entry.key == "pushes") {
      const std::vector<YAML::Node> pushes = ListOf(entry.value, "'pushes'");
      if (pushes.size() > kMostPushes)
        RefuseYaml(entry.value,
                   fmt::format("there are {} pushes; at most {} are accepted", pushes.size(), kMostPushes));
      for (const YAML::Node& push : pushes) disturbances.pushes.push_back(ReadPush(push));
    } else {
      const auto rule = std::find_if(own.begin(), own.end(), [&](const auto& r) { return r.key == entry.key; });
      add({{entry.key, ReadDistribution(entry.value, *rule)}});
    }
  }
  if (disturbances.figures.empty() && disturbances.pushes.empty())
    RefuseYaml(root,
               "the file contains no disturbances: its groups are empty; to disturb nothing, write mass_scale: 1");
  for (const char* axis : {"com_shift_x_m", "com_shift_y_m", "com_shift_z_m"})
    NotBoth(root, disturbances.figures, "com_shift_m", axis);
  return disturbances;
}

/// A word as YAML, in quotes if it would otherwise be read as another type.
std::string Quoted(const std::string& word) {
  const bool plain = !word.empty() && std::isalpha(static_cast<unsigned char>(word.front())) != 0 &&
                     std::all_of(word.begin(), word.end(),
                                 [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; });
  return plain ? word
               : nlohmann::ordered_json(word).dump(-1, ' ', true, nlohmann::ordered_json::error_handler_t::replace);
}

std::string QuotedWords(const std::vector<std::string>& words) {
  std::vector<std::string> quoted;
  for (const std::string& word : words) quoted.push_back(Quoted(word));
  return fmt::format("{}", fmt::join(quoted, ", "));
}

std::string Words(const Distribution& d) {
  switch (d.kind) {
    case Distribution::Kind::kUniform:
      return fmt::format("{{uniform: [{}, {}]}}", d.lowest, d.highest);
    case Distribution::Kind::kNormal:
      return fmt::format("{{normal: {{mean: {}, std: {}, lowest: {}, highest: {}}}}}", d.mean, d.std, d.lowest,
                         d.highest);
    case Distribution::Kind::kNumbers:
      return fmt::format("{{choice: [{}]}}", fmt::join(d.numbers, ", "));
    case Distribution::Kind::kWords:
      return fmt::format("{{choice: [{}]}}", QuotedWords(d.words));
    default:
      return fmt::format("{}", d.lowest);
  }
}

}  // namespace

DataShape DisturbancesShape(const OptionFields& sensors) {
  using namespace shapes;
  DataShape shape = FiguresShape(RulesOf(""));
  DataShape push = FiguresShape(PushRules());
  push.one_of = {{"size_n", "size_of_weight"}};
  shape.members.push_back(Optional("start", FiguresShape(RulesOf("start")), "Offset of the start from the plan."));
  shape.members.push_back(Optional("sensors", FiguresShape(SensorRules(sensors)), "Sensor options."));
  shape.members.push_back(Optional("pushes", List(push, 0, kMostPushes), "Pushes, each of which acts in every trial."));
  shape.least = 1;
  return shape;
}

Result<Disturbances> ReadDisturbances(const std::string& text, const OptionFields& sensors, const std::string& source) {
  const auto bad = [&](const std::string& message) {
    return Failure{FailureKind::kBadInput,
                   FailureCode::kDisturbances,
                   "ReadDisturbances",
                   fmt::format("'{}', {}", source, message),
                   {"docs/trials.md lists all keys"}};
  };
  try {
    const YAML::Node root = LoadYaml(text);
    if (!root.IsMap() || root.size() == 0)
      return bad("line 1: contains no disturbances; a map of keys is needed; to disturb nothing, write mass_scale: 1");
    return ReadRoot(root, sensors);
  } catch (const YAML::Exception& error) {
    return bad(fmt::format("line {}: not valid YAML from here on", error.mark.line + 1));
  } catch (const InvalidArgument& error) {
    return bad(error.what());
  }
}

Result<Disturbances> LoadDisturbances(const std::string& path, const OptionFields& sensors) {
  const Result<std::string> text = ReadFile(path);
  if (!text) return text.failure();
  return ReadDisturbances(*text, sensors, path);
}

std::string DisturbancesText(const Disturbances& disturbances) {
  std::string text;
  for (const char* group : {"", "start", "sensors"}) {
    const std::string prefix = *group == 0 ? "" : std::string(group) + ".";
    bool headed = prefix.empty();
    for (const auto& [key, distribution] : disturbances.figures) {
      const std::size_t dot = key.find('.');
      if ((dot == std::string::npos ? "" : key.substr(0, dot)) != group) continue;
      if (!headed) text += std::string(group) + ":\n";
      headed = true;
      const std::string own = dot == std::string::npos ? key : "  " + key.substr(dot + 1);
      text += fmt::format("{}: {}\n", own, Words(distribution));
    }
  }
  if (!disturbances.pushes.empty()) text += "pushes:\n";
  for (const DisturbedPush& push : disturbances.pushes) {
    for (std::size_t i = 0; i < push.size(); ++i)
      text += fmt::format("  {} {}: {}\n", i == 0 ? "-" : " ", push[i].key, Words(push[i].distribution));
  }
  return text;
}

Disturbances StandardDisturbances(const RobotModel& model) {
  const double leg = model.leg_length_m();
  const auto within = [](double half) { return Distribution::Uniform(-half, half); };
  const auto up_to = [](double most) { return Distribution::Uniform(0.0, most); };
  const Distribution tenth = Distribution::Uniform(0.9, 1.1);
  Disturbances d;
  d.figures = {{"mass_scale", tenth},
               {"inertia_scale", tenth},
               {"com_shift_m", up_to(0.03 * leg)},
               {"friction", Distribution::Uniform(0.5, 1.0)},
               {"ground_slope_deg", up_to(2.0)},
               {"ground_slope_direction_deg", up_to(360.0)},
               {"ground_bumps_m", up_to(0.01 * leg)},
               {"latency_s", up_to(0.004)},
               {"motor_strength", Distribution::Uniform(0.9, 1.0)},
               {"stiffness_scale", tenth},
               {"damping_scale", tenth},
               {"start.x_m", within(0.01 * leg)},
               {"start.y_m", within(0.01 * leg)},
               {"start.roll_rad", within(0.02)},
               {"start.pitch_rad", within(0.02)},
               {"start.yaw_rad", within(0.02)},
               {"start.joints_rad", within(0.01)}};
  d.pushes = {{{"size_of_weight", up_to(0.1)},
               {"direction_deg", up_to(360.0)},
               {"at_share", Distribution::Uniform(0.1, 0.9)},
               {"duration_s", Distribution::Fixed(0.1)}}};
  return d;
}

}  // namespace gaitwright
