// SPDX-License-Identifier: BSD-3-Clause
#include "planning/gait/load_gaits.h"

#include <fmt/format.h>

#include <algorithm>

#include "kinematics/base/data_path.h"
#include "kinematics/base/file.h"
#include "kinematics/base/strict_yaml_internal.h"
#include "planning/gait/file_shapes.h"

namespace gaitwright {
namespace {

/// One number for all feet, or a list with one number per foot.
DataShape ByFootShape(double lowest, double highest) {
  return shapes::Either(shapes::Number(lowest, highest), shapes::List(shapes::Number(lowest, highest), 1));
}

DataShape GaitShape() {
  using namespace shapes;
  return Object(
      {{"feet", Whole(1, 64), "Number of feet; lists with one entry per foot are in the robot's order."},
       Optional("description", Text(), "One-line description for the list of gaits."),
       Optional("cycle_s", Number(0.05, 20.0), "Duration of a cycle at any speed."),
       Optional("cycle_per_leg_time", Number(0.1, 100.0),
                "Cycle time divided by sqrt(leg length / g), for robots of any size."),
       {"duty_factor", ByFootShape(0.05, 0.99), "Share of the cycle during which a foot is on the ground."},
       {"phase", ByFootShape(0.0, 0.9999999), "Share of the cycle at which a foot touches down."},
       Optional("stride_per_leg", Number(0.05, 10.0), "Largest stride in leg lengths, used if no speed is given."),
       Optional("shortest_cycle", Number(0.05, 1.0),
                "Shortest cycle for high speeds as a share of the default cycle; default 0.5."),
       Optional("roll_turns", Whole(-2, 2),
                "Turns of the body about its x axis in each cycle; needs 'travel_per_leg'."),
       Optional("pitch_turns", Whole(-2, 2),
                "Turns of the body about its y axis in each cycle; needs 'travel_per_leg'."),
       Optional("travel_per_leg", List(Number(-10.0, 10.0), 2, 2),
                "Forward and lateral travel of the body in each cycle, in leg lengths, of a gait that turns over.")},
      {{"cycle_s", "cycle_per_leg_time"}});
}

std::vector<double> ByFoot(const YAML::Node& node, const std::string& what, int feet, const DataShape& shape) {
  if (node.IsScalar()) return std::vector<double>(static_cast<std::size_t>(feet), NumberOf(node, what, shape));
  if (!node.IsSequence()) {
    RefuseYaml(node,
               fmt::format("{} is {}; accepted: a number, or a list with one number per foot", what, KindOf(node)));
  }
  std::vector<double> values;
  for (const YAML::Node& entry : node) values.push_back(NumberOf(entry, what, shape));
  if (static_cast<int>(values.size()) != feet)
    RefuseYaml(node, fmt::format("{} has {} entries for {} feet", what, values.size(), feet));
  return values;
}

/// The keys of one gait.
YamlMap KeysOf(const std::string& name, const YAML::Node& node, const DataShape& shape) {
  YamlMap map(node, fmt::format("gait '{}'", name), shape);
  const bool both = map.Find("cycle_s") != nullptr && map.Find("cycle_per_leg_time") != nullptr;
  if (both || (map.Find("cycle_s") == nullptr && map.Find("cycle_per_leg_time") == nullptr)) {
    RefuseYaml(node, fmt::format("gait '{}' {} the keys 'cycle_s' and 'cycle_per_leg_time'; one of them is needed",
                                 name, both ? "has both of" : "lacks both of"));
  }
  return map;
}

GaitEntry ParseGait(const std::string& name, const YAML::Node& node) {
  const DataShape shape = GaitShape();
  const YamlMap map = KeysOf(name, node, shape);
  GaitEntry entry;
  entry.gait.name = name;
  if (const YAML::Node* description = map.Find("description"))
    entry.gait.description = TextOf(*description, "description");
  const auto number = [&](const char* key) {
    const YAML::Node* value = map.Find(key);
    return value == nullptr ? 0.0 : NumberOf(*value, key, shape.At(key));
  };
  const auto by_foot = [&](const char* key, int feet) { return ByFoot(*map.Find(key), key, feet, shape.At(key)); };
  const int feet = static_cast<int>(number("feet"));
  entry.gait.cycle_s = number("cycle_s");
  entry.cycle_per_leg_time = number("cycle_per_leg_time");
  entry.stride_per_leg = number("stride_per_leg");
  if (map.Find("shortest_cycle") != nullptr) entry.shortest_cycle = number("shortest_cycle");
  entry.gait.duty_factor = by_foot("duty_factor", feet);
  entry.gait.phase = by_foot("phase", feet);
  entry.gait.roll_turns = number("roll_turns");
  entry.gait.pitch_turns = number("pitch_turns");
  if (const YAML::Node* travel = map.Find("travel_per_leg")) {
    const std::vector<double> xy = ByFoot(*travel, "travel_per_leg", 2, shape.At("travel_per_leg"));
    entry.travel_per_leg = {xy[0], xy[1]};
  }
  if (TurnsOver(entry.gait) != entry.travel_per_leg.has_value() ||
      (entry.gait.roll_turns != 0.0 && entry.gait.pitch_turns != 0.0)) {
    RefuseYaml(node, fmt::format("gait '{}' needs 'travel_per_leg' together with one of 'roll_turns' and 'pitch_turns'",
                                 name));
  }
  return entry;
}

GaitEntry Wave(int num_feet) {
  constexpr double kShareOfTurn = 0.6, kLegTimesPerFoot = 2.0;  // duty factor and cycle of the crawl
  GaitEntry wave;
  wave.gait.name = "wave";
  wave.gait.description = "one foot at a time, from rear to front";
  wave.gait.cycle_s = 0.0;
  wave.cycle_per_leg_time = kLegTimesPerFoot * num_feet;
  wave.gait.duty_factor.assign(static_cast<std::size_t>(num_feet), 1.0 - kShareOfTurn / num_feet);
  const int rows = num_feet / 2;
  for (int foot = 0; foot < num_feet; ++foot) {
    const int turn = num_feet % 2 != 0 ? num_feet - 1 - foot : rows - 1 - foot / 2 + (foot % 2) * rows;
    wave.gait.phase.push_back(static_cast<double>(turn) / num_feet);
  }
  return wave;
}

GaitEntry Alternating(int num_feet) {
  GaitEntry sets;
  sets.gait.name = "alternating";
  sets.gait.description = "two alternating sets of feet, with neighbours in different sets";
  sets.gait.cycle_s = 0.0;
  sets.cycle_per_leg_time = 3.4;  // same value as for the tripod
  sets.gait.duty_factor.assign(static_cast<std::size_t>(num_feet), 0.6);
  for (int foot = 0; foot < num_feet; ++foot) sets.gait.phase.push_back((foot / 2 + foot % 2) % 2 == 0 ? 0.0 : 0.5);
  return sets;
}

}  // namespace

DataShape GaitFileShape() { return shapes::MapOf(GaitShape(), 1); }

Result<std::vector<GaitEntry>> LoadGaits(const std::string& path) {
  const auto bad = [&](const std::string& message) {
    return Failure{FailureKind::kBadInput, FailureCode::kGait, "LoadGaits", fmt::format("'{}', {}", path, message), {}};
  };
  const Result<std::string> text = ReadFile(path);
  if (!text) return text.failure();
  std::vector<GaitEntry> gaits;
  try {
    const YAML::Node root = LoadYaml(*text);
    if (!root.IsMap() || root.size() == 0) return bad("line 1: contains no gaits; a map of names to gaits is needed");
    const YamlMap map(root, "the file");
    for (const YamlMap::Entry& entry : map.entries()) gaits.push_back(ParseGait(entry.key, entry.value));
  } catch (const YAML::Exception& error) {
    return bad(fmt::format("line {}: not valid YAML from here on; see docs/gaits.md", error.mark.line + 1));
  } catch (const InvalidArgument& error) {
    return bad(error.what());
  }
  return gaits;
}

std::string BuiltInGaitsFile() { return DataPath("gaits.yaml", "GAITWRIGHT_GAITS"); }

Result<std::vector<GaitEntry>> BuiltInGaits() { return LoadGaits(BuiltInGaitsFile()); }

std::vector<GaitEntry> GeneratedGaits(int num_feet) {
  std::vector<GaitEntry> gaits;
  if (num_feet >= 3) gaits.push_back(Wave(num_feet));
  if (num_feet >= 6 && num_feet % 2 == 0) gaits.push_back(Alternating(num_feet));
  return gaits;
}

}  // namespace gaitwright
