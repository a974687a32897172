// SPDX-License-Identifier: BSD-3-Clause
#include "planning/gait/find_gait.h"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "kinematics/base/file.h"

namespace gaitwright {
namespace {

Failure BadGait(const std::string& message) { return {FailureKind::kBadInput, "gait", "FindGait", message, {}}; }

double FiniteNumber(const YAML::Node& node, const std::string& what, double low, double high) {
  double value = 0.0;
  try {
    value = node.as<double>();
  } catch (const YAML::Exception&) {
    throw InvalidArgument(fmt::format("line {}: {} is not a number", node.Mark().line + 1, what));
  }
  if (!std::isfinite(value) || value < low || value > high) {
    throw InvalidArgument(
        fmt::format("line {}: {} is {}; accepted: {} to {}", node.Mark().line + 1, what, value, low, high));
  }
  return value;
}

std::vector<double> ByFoot(const YAML::Node& node, const std::string& what, int feet, double low, double high) {
  if (node.IsScalar()) return std::vector<double>(static_cast<std::size_t>(feet), FiniteNumber(node, what, low, high));
  std::vector<double> values;
  for (const YAML::Node& entry : node) values.push_back(FiniteNumber(entry, what, low, high));
  if (static_cast<int>(values.size()) != feet) {
    throw InvalidArgument(
        fmt::format("line {}: {} has {} entries for {} feet", node.Mark().line + 1, what, values.size(), feet));
  }
  return values;
}

GaitEntry ParseGait(const std::string& name, const YAML::Node& node) {
  const std::vector<std::string> known = {"feet",        "description", "cycle_s", "cycle_per_leg_time",
                                          "duty_factor", "phase"};
  for (const auto& entry : node) {
    const auto key = entry.first.as<std::string>();
    if (std::find(known.begin(), known.end(), key) == known.end()) {
      throw InvalidArgument(fmt::format("line {}: gait '{}' has the unknown key '{}'; the nearest is '{}'",
                                        entry.first.Mark().line + 1, name, key, NearestName(key, known)));
    }
  }
  for (const char* needed : {"feet", "duty_factor", "phase"}) {
    if (!node[needed]) throw InvalidArgument(fmt::format("gait '{}' lacks the key '{}'", name, needed));
  }
  if (!node["cycle_s"] && !node["cycle_per_leg_time"]) {
    throw InvalidArgument(fmt::format("gait '{}' lacks the key 'cycle_s' or 'cycle_per_leg_time'", name));
  }
  GaitEntry entry;
  entry.gait.name = name;
  if (node["description"]) entry.gait.description = node["description"].as<std::string>();
  const int feet = static_cast<int>(FiniteNumber(node["feet"], "feet", 1, 64));
  entry.gait.cycle_s = node["cycle_s"] ? FiniteNumber(node["cycle_s"], "cycle_s", 0.05, 20.0) : 0.0;
  if (node["cycle_per_leg_time"])
    entry.cycle_per_leg_time = FiniteNumber(node["cycle_per_leg_time"], "cycle_per_leg_time", 0.1, 100.0);
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

/// The name that "walk" and "" stand for.
std::string ResolvedName(const std::string& name, int feet) {
  if (name.empty()) return feet == 2 ? "biped" : feet == 4 ? "trot" : "tripod";
  if (name == "walk") return feet == 2 ? "biped" : feet == 4 ? "crawl" : "tripod";
  return name;
}

Gait Fitted(const GaitEntry& entry, const RobotModel& model, double speed_m_s, const GaitOptions& options) {
  Gait gait = entry.gait;
  if (options.duty_factor > 0.0) std::fill(gait.duty_factor.begin(), gait.duty_factor.end(), options.duty_factor);
  if (gait.cycle_s <= 0.0) {
    gait.cycle_s = entry.cycle_per_leg_time * std::sqrt(model.leg_length_m() / kGravity);
    const double duty = *std::max_element(gait.duty_factor.begin(), gait.duty_factor.end());
    const double travel = options.stance_travel * model.leg_length_m();
    constexpr double kShortest = 0.5;  // of the gait's own cycle
    gait.cycle_s = std::clamp(travel / std::max(speed_m_s * duty, 1e-9), kShortest * gait.cycle_s, gait.cycle_s);
  }
  if (options.cycle_s > 0.0) gait.cycle_s = options.cycle_s;
  return gait;
}

}  // namespace

Result<std::vector<GaitEntry>> LoadGaits(const std::string& path) {
  const Result<std::string> text = ReadFile(path);
  if (!text) return text.failure();
  std::vector<GaitEntry> gaits;
  try {
    const YAML::Node root = YAML::Load(*text);
    if (!root.IsMap()) return BadGait(fmt::format("'{}' holds no gaits: a map of names to gaits is needed", path));
    for (const auto& entry : root) gaits.push_back(ParseGait(entry.first.as<std::string>(), entry.second));
  } catch (const YAML::Exception& error) {
    return BadGait(fmt::format("'{}', line {}: {}", path, error.mark.line + 1, error.msg));
  } catch (const InvalidArgument& error) {
    return BadGait(fmt::format("'{}', {}", path, error.what()));
  }
  return gaits;
}

Result<std::vector<GaitEntry>> BuiltInGaits() { return LoadGaits(BuiltInFile()); }

Result<Gait> FindGait(const RobotModel& model, const std::string& name, double speed_m_s, const GaitOptions& options) {
  const int feet = static_cast<int>(model.feet.size());
  const bool is_file = name.ends_with(".yaml") || name.ends_with(".yml");
  const Result<std::vector<GaitEntry>> gaits = is_file ? LoadGaits(name) : BuiltInGaits();
  if (!gaits) return gaits.failure();
  const std::string wanted = ResolvedName(name, feet);
  std::vector<std::string> names;
  for (const GaitEntry& entry : *gaits) {
    if (entry.gait.num_feet() != feet) continue;
    if (is_file || entry.gait.name == wanted) return Fitted(entry, model, speed_m_s, options);
    names.push_back(entry.gait.name);
  }
  return BadGait(fmt::format("there is no gait '{}' for {} feet; there are {}", name, feet, QuotedList(names)));
}

}  // namespace gaitwright
