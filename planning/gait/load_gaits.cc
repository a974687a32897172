// SPDX-License-Identifier: BSD-3-Clause
#include "planning/gait/load_gaits.h"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <set>

#include "kinematics/base/file.h"
#include "kinematics/base/options.h"

namespace gaitwright {
namespace {

/// Thrown within this file: what is wrong and where.
[[noreturn]] void Refuse(const YAML::Node& node, const std::string& what) {
  throw InvalidArgument(fmt::format("line {}: {}", node.Mark().line + 1, what));
}

const char* KindOf(const YAML::Node& node) {
  return node.IsMap() ? "a map" : node.IsSequence() ? "a list" : node.IsScalar() ? "a single value" : "nothing";
}

double FiniteNumber(const YAML::Node& node, const std::string& what, double low, double high) {
  if (!node.IsScalar()) Refuse(node, fmt::format("{} is {}; a number is needed", what, KindOf(node)));
  double value = 0.0;
  try {
    value = node.as<double>();
  } catch (const YAML::Exception&) {
    Refuse(node, fmt::format("{} is '{}'; a number is needed", what, node.Scalar()));
  }
  if (!std::isfinite(value) || value < low || value > high)
    Refuse(node, fmt::format("{} is {}; accepted: {} to {}", what, value, low, high));
  return value;
}

int WholeNumber(const YAML::Node& node, const std::string& what, int low, int high) {
  const double value = FiniteNumber(node, what, low, high);
  if (value != std::floor(value)) Refuse(node, fmt::format("{} is {}; a whole number is needed", what, value));
  return static_cast<int>(value);
}

std::vector<double> ByFoot(const YAML::Node& node, const std::string& what, int feet, double low, double high) {
  if (node.IsScalar()) return std::vector<double>(static_cast<std::size_t>(feet), FiniteNumber(node, what, low, high));
  if (!node.IsSequence()) {
    Refuse(node, fmt::format("{} is {}; a number is needed, or a list of one for each foot", what, KindOf(node)));
  }
  std::vector<double> values;
  for (const YAML::Node& entry : node) values.push_back(FiniteNumber(entry, what, low, high));
  if (static_cast<int>(values.size()) != feet)
    Refuse(node, fmt::format("{} has {} entries for {} feet", what, values.size(), feet));
  return values;
}

/// The name of an entry of a map, refused when it is no plain text or stands there twice.
std::string UniqueName(const YAML::Node& node, const std::string& what, std::set<std::string>& seen) {
  if (!node.IsScalar()) Refuse(node, fmt::format("{} is {}; a name is needed", what, KindOf(node)));
  if (!seen.insert(node.Scalar()).second) Refuse(node, fmt::format("{} '{}' stands there twice", what, node.Scalar()));
  return node.Scalar();
}

void CheckKeys(const std::string& name, const YAML::Node& node) {
  const std::vector<std::string> known = {"feet",        "description", "cycle_s",       "cycle_per_leg_time",
                                          "duty_factor", "phase",       "stride_per_leg"};
  std::set<std::string> seen;
  for (const auto& entry : node) {
    const std::string key = UniqueName(entry.first, fmt::format("in gait '{}' the key", name), seen);
    if (std::find(known.begin(), known.end(), key) == known.end()) {
      Refuse(entry.first, fmt::format("gait '{}' has the unknown key '{}'; the nearest is '{}'", name, key,
                                      NearestName(key, known)));
    }
  }
  for (const char* needed : {"feet", "duty_factor", "phase"}) {
    if (!seen.contains(needed)) Refuse(node, fmt::format("gait '{}' lacks the key '{}'", name, needed));
  }
  if (seen.contains("cycle_s") == seen.contains("cycle_per_leg_time")) {
    Refuse(node, fmt::format("gait '{}' {} the keys 'cycle_s' and 'cycle_per_leg_time'; one of them is needed", name,
                             seen.contains("cycle_s") ? "has both of" : "lacks both of"));
  }
}

GaitEntry ParseGait(const std::string& name, const YAML::Node& node) {
  if (!node.IsMap()) Refuse(node, fmt::format("gait '{}' is {}; a map of keys is needed", name, KindOf(node)));
  CheckKeys(name, node);
  GaitEntry entry;
  entry.gait.name = name;
  if (node["description"]) {
    const YAML::Node description = node["description"];
    if (!description.IsScalar())
      Refuse(description, fmt::format("description is {}; a text is needed", KindOf(description)));
    entry.gait.description = description.Scalar();
  }
  const int feet = WholeNumber(node["feet"], "feet", 1, 64);
  entry.gait.cycle_s = node["cycle_s"] ? FiniteNumber(node["cycle_s"], "cycle_s", 0.05, 20.0) : 0.0;
  if (node["cycle_per_leg_time"])
    entry.cycle_per_leg_time = FiniteNumber(node["cycle_per_leg_time"], "cycle_per_leg_time", 0.1, 100.0);
  if (node["stride_per_leg"]) entry.stride_per_leg = FiniteNumber(node["stride_per_leg"], "stride_per_leg", 0.05, 10.0);
  entry.gait.duty_factor = ByFoot(node["duty_factor"], "duty_factor", feet, 0.05, 0.99);
  entry.gait.phase = ByFoot(node["phase"], "phase", feet, 0.0, 0.9999999);
  return entry;
}

std::string BuiltInFile() {
  if (const char* file = std::getenv("GAITWRIGHT_GAITS")) return file;
  namespace fs = std::filesystem;
  std::error_code error;
  if (fs::exists(GAITWRIGHT_SOURCE_GAITS, error)) return GAITWRIGHT_SOURCE_GAITS;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  const fs::path beside = program.parent_path().parent_path() / "share/gaitwright/gaits.yaml";
  return !error && fs::exists(beside, error) ? beside.string() : GAITWRIGHT_INSTALLED_GAITS;
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
    const YAML::Node root = YAML::Load(*text);
    if (!root.IsMap() || root.size() == 0) return bad("line 1: holds no gaits: a map of names to gaits is needed");
    std::set<std::string> names;
    for (const auto& entry : root) {
      const std::string name = UniqueName(entry.first, "the gait", names);
      gaits.push_back(ParseGait(name, entry.second));
    }
  } catch (const YAML::Exception& error) {
    return bad(fmt::format("line {}: is no YAML from here on; see docs/gaits.md", error.mark.line + 1));
  } catch (const InvalidArgument& error) {
    return bad(error.what());
  }
  return gaits;
}

Result<std::vector<GaitEntry>> BuiltInGaits() { return LoadGaits(BuiltInFile()); }

std::vector<GaitEntry> GeneratedGaits(int num_feet) {
  std::vector<GaitEntry> gaits;
  if (num_feet >= 3) gaits.push_back(Wave(num_feet));
  if (num_feet >= 6 && num_feet % 2 == 0) gaits.push_back(Alternating(num_feet));
  return gaits;
}

}  // namespace gaitwright
