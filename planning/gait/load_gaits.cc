// SPDX-License-Identifier: BSD-3-Clause
#include "planning/gait/load_gaits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "kinematics/base/file.h"
#include "kinematics/base/strict_yaml_internal.h"

namespace gaitwright {
namespace {

int WholeNumber(const YAML::Node& node, const std::string& what, int low, int high) {
  const double value = NumberOf(node, what, low, high);
  if (value != std::floor(value)) RefuseYaml(node, fmt::format("{} is {}; a whole number is needed", what, value));
  return static_cast<int>(value);
}

std::vector<double> ByFoot(const YAML::Node& node, const std::string& what, int feet, double low, double high) {
  if (node.IsScalar()) return std::vector<double>(static_cast<std::size_t>(feet), NumberOf(node, what, low, high));
  if (!node.IsSequence()) {
    RefuseYaml(node, fmt::format("{} is {}; a number is needed, or a list of one for each foot", what, KindOf(node)));
  }
  std::vector<double> values;
  for (const YAML::Node& entry : node) values.push_back(NumberOf(entry, what, low, high));
  if (static_cast<int>(values.size()) != feet)
    RefuseYaml(node, fmt::format("{} has {} entries for {} feet", what, values.size(), feet));
  return values;
}

/// A gait's keys.
YamlMap KeysOf(const std::string& name, const YAML::Node& node) {
  YamlMap map(node, fmt::format("gait '{}'", name),
              {"feet", "description", "cycle_s", "cycle_per_leg_time", "duty_factor", "phase", "stride_per_leg"});
  map.Require({"feet", "duty_factor", "phase"});
  const bool both = map.Find("cycle_s") != nullptr && map.Find("cycle_per_leg_time") != nullptr;
  if (both || (map.Find("cycle_s") == nullptr && map.Find("cycle_per_leg_time") == nullptr)) {
    RefuseYaml(node, fmt::format("gait '{}' {} the keys 'cycle_s' and 'cycle_per_leg_time'; one of them is needed",
                                 name, both ? "has both of" : "lacks both of"));
  }
  return map;
}

GaitEntry ParseGait(const std::string& name, const YAML::Node& node) {
  const YamlMap map = KeysOf(name, node);
  GaitEntry entry;
  entry.gait.name = name;
  if (const YAML::Node* description = map.Find("description"))
    entry.gait.description = TextOf(*description, "description");
  const auto number = [&](const char* key, double low, double high) {
    const YAML::Node* value = map.Find(key);
    return value == nullptr ? 0.0 : NumberOf(*value, key, low, high);
  };
  const int feet = WholeNumber(*map.Find("feet"), "feet", 1, 64);
  entry.gait.cycle_s = number("cycle_s", 0.05, 20.0);
  entry.cycle_per_leg_time = number("cycle_per_leg_time", 0.1, 100.0);
  entry.stride_per_leg = number("stride_per_leg", 0.05, 10.0);
  entry.gait.duty_factor = ByFoot(*map.Find("duty_factor"), "duty_factor", feet, 0.05, 0.99);
  entry.gait.phase = ByFoot(*map.Find("phase"), "phase", feet, 0.0, 0.9999999);
  return entry;
}

GaitEntry Wave(int num_feet) {
  constexpr double kShareOfTurn = 0.6, kLegTimesPerFoot = 2.0;  // those of the crawl
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
  sets.gait.description = "two sets of feet in turn, neighbours in different ones";
  sets.gait.cycle_s = 0.0;
  sets.cycle_per_leg_time = 3.4;  // as the tripod
  sets.gait.duty_factor.assign(static_cast<std::size_t>(num_feet), 0.6);
  for (int foot = 0; foot < num_feet; ++foot) sets.gait.phase.push_back((foot / 2 + foot % 2) % 2 == 0 ? 0.0 : 0.5);
  return sets;
}

}  // namespace

Result<std::vector<GaitEntry>> LoadGaits(const std::string& path) {
  const auto bad = [&](const std::string& message) {
    return Failure{FailureKind::kBadInput, "gait", "LoadGaits", fmt::format("'{}', {}", path, message), {}};
  };
  const Result<std::string> text = ReadFile(path);
  if (!text) return text.failure();
  std::vector<GaitEntry> gaits;
  try {
    const YAML::Node root = LoadYaml(*text);
    if (!root.IsMap() || root.size() == 0) return bad("line 1: holds no gaits: a map of names to gaits is needed");
    const YamlMap map(root, "the file");
    for (const YamlMap::Entry& entry : map.entries()) gaits.push_back(ParseGait(entry.key, entry.value));
  } catch (const YAML::Exception& error) {
    return bad(fmt::format("line {}: is no YAML from here on; see docs/gaits.md", error.mark.line + 1));
  } catch (const InvalidArgument& error) {
    return bad(error.what());
  }
  return gaits;
}

std::string BuiltInGaitsFile() {
  if (const char* file = std::getenv("GAITWRIGHT_GAITS")) return file;
  namespace fs = std::filesystem;
  std::error_code error;
  if (fs::exists(GAITWRIGHT_SOURCE_GAITS, error)) return GAITWRIGHT_SOURCE_GAITS;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  const fs::path beside = program.parent_path().parent_path() / "share/gaitwright/gaits.yaml";
  return !error && fs::exists(beside, error) ? beside.string() : GAITWRIGHT_INSTALLED_GAITS;
}

Result<std::vector<GaitEntry>> BuiltInGaits() { return LoadGaits(BuiltInGaitsFile()); }

std::vector<GaitEntry> GeneratedGaits(int num_feet) {
  std::vector<GaitEntry> gaits;
  if (num_feet >= 3) gaits.push_back(Wave(num_feet));
  if (num_feet >= 6 && num_feet % 2 == 0) gaits.push_back(Alternating(num_feet));
  return gaits;
}

}  // namespace gaitwright
