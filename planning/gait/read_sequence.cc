// SPDX-License-Identifier: BSD-3-Clause
#include "planning/gait/read_sequence.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "kinematics/base/file.h"
#include "kinematics/base/options.h"
#include "kinematics/base/strict_yaml_internal.h"
#include "kinematics/base/text.h"
#include "planning/gait/file_shapes.h"
#include "planning/gait/find_gait.h"
#include "planning/plan/terrain_spec.h"

namespace gaitwright {
namespace {

bool Has(const OptionTexts& texts, const std::string& key) {
  return std::any_of(texts.begin(), texts.end(), [&](const auto& text) { return text.first == key; });
}

/// Keys of a part, with their ranges.
OptionFields FieldsOf(WalkCommand& c) {
  constexpr double kFast = 50.0, kFar = 10000.0, kLong = 600.0, kMany = 100000.0, kStride = 10.0;
  return {{"speed", &c.speed_m_s, "m/s", -kFast, kFast, "Forward speed; negative is backward."},
          {"lateral-speed", &c.lateral_speed_m_s, "m/s", -kFast, kFast, "Lateral speed; positive is to the left."},
          {"yaw-rate", &c.yaw_rate_rad_s, "rad/s", -kFast, kFast, "Yaw rate; positive is to the left."},
          {"distance", &c.distance_m, "m", 0.0, kFar, "Distance to walk."},
          {"duration", &c.duration_s, "s", 0.0, kLong, "Time to walk or stand."},
          {"steps", &c.steps, "1", 1.0, kMany, "Number of footfalls."},
          {"step-length", &c.step_length_m, "m", -kStride, kStride, "Forward advance of the robot in each footfall."}};
}

/// Extent of a command. @throws InvalidArgument if the distance is given twice or is missing.
void SetExtent(const OptionTexts& texts, WalkCommand& c) {
  std::vector<std::string> given;
  for (const char* key : {"distance", "duration", "steps"}) {
    if (Has(texts, key)) given.emplace_back(key);
  }
  if (given.size() > 1)
    throw InvalidArgument(fmt::format("{} each set the distance; give only one of them", QuotedList(given)));
  const bool somewhere = c.speed_m_s != 0.0 || c.lateral_speed_m_s != 0.0;
  if (Has(texts, "step-length") && (!Has(texts, "steps") || c.speed_m_s != 0.0))
    throw InvalidArgument("'step-length' is for use with 'steps', instead of 'speed'");
  if (Has(texts, "distance") && c.distance_m == 0.0) throw InvalidArgument("the distance is 0; it must be more than 0");
  if (Has(texts, "duration")) {
    c.extent = WalkCommand::Extent::kDuration;
  } else if (Has(texts, "steps")) {
    c.extent = WalkCommand::Extent::kSteps;
    if (!somewhere && c.yaw_rate_rad_s == 0.0 && !Has(texts, "step-length"))
      throw InvalidArgument("'steps' alone do not set a distance: also give 'step-length' or 'speed'");
  } else if (!Has(texts, "distance")) {
    c.distance_m = somewhere || c.yaw_rate_rad_s == 0.0 ? 1.0 : 0.0;
  }
}

/// @throws InvalidArgument for an unknown key, a key that does not fit the others, and a wrong value.
AskedPart PartOf(const std::string& gait, const OptionTexts& texts) {
  AskedPart part{gait, {}};
  if (part.stands()) {
    for (const auto& [key, text] : texts) {
      if (key != "duration")
        throw InvalidArgument(fmt::format("'{}' does not apply to standing still; it accepts 'duration' only", key));
    }
    if (texts.empty()) throw InvalidArgument("the time to stand is missing: give 'duration'");
  }
  OptionFields fields = FieldsOf(part.command);
  for (const auto& [key, text] : texts) SetOption(fields, key, text);
  SetExtent(texts, part.command);
  return part;
}

/// A part as text: a gait, then a colon and its keys.
AskedPart ParsePart(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) return PartOf(text, {});
  const std::size_t colon = text.rfind(':', equals);
  if (colon == std::string::npos || colon == 0)
    throw InvalidArgument(fmt::format("'{}' has no gait before it; write 'GAIT: key=value, key=value'", text));
  std::string parameters = text.substr(colon + 1);
  std::erase_if(parameters, [](char c) { return c == ' ' || c == '\t' || c == '\n'; });
  return PartOf(Trimmed(text.substr(0, colon)), ParseParameters(parameters));
}

std::vector<AskedPart> ParseParts(const std::string& text) {
  std::vector<AskedPart> parts;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(';', at), text.size());
    const std::string part = Trimmed(text.substr(at, end - at));
    const std::string name = fmt::format("part {}", parts.size() + 1);
    if (part.empty()) throw InvalidArgument(name + " is empty; separate parts with semicolons");
    try {
      parts.push_back(ParsePart(part));
    } catch (const InvalidArgument& error) {
      throw InvalidArgument(fmt::format("{}, '{}': {}", name, part.substr(0, part.find(':')), error.what()));
    }
    at = end + 1;
  }
  return parts;
}

AskedPart ParseNode(const YAML::Node& node, const std::string& folder) {
  const YamlMap map(node, "a part");
  map.Require({"gait"});
  std::string gait;
  OptionTexts texts;
  for (const YamlMap::Entry& entry : map.entries()) {
    const std::string value = TextOf(entry.value, fmt::format("'{}'", entry.key));
    if (entry.key == "gait") {
      gait = value;
    } else {
      texts.emplace_back(entry.key, value);
    }
  }
  if (gait.empty()) RefuseYaml(node, "a part lacks the key 'gait'");
  const std::string file = GaitFileOf(gait);
  if (!file.empty()) gait = (std::filesystem::path(folder) / file).string() + gait.substr(file.size());
  try {
    return PartOf(gait, texts);
  } catch (const InvalidArgument& error) {
    RefuseYaml(node, fmt::format("'{}': {}", gait, error.what()));
  }
}

Result<std::vector<AskedPart>> ReadFileOfParts(const std::string& path) {
  const auto bad = [&](const std::string& message) {
    return Failure{
        FailureKind::kBadInput, FailureCode::kSequence, "ReadSequence", fmt::format("'{}', {}", path, message), {}};
  };
  const Result<std::string> text = ReadFile(path);
  if (!text) return text.failure();
  try {
    const YAML::Node root = LoadYaml(*text);
    if (!root.IsSequence() || root.size() == 0) return bad("line 1: contains no sequence; a list of parts is needed");
    std::vector<AskedPart> parts;
    const std::string folder = std::filesystem::path(path).parent_path().string();
    for (const YAML::Node& node : root) parts.push_back(ParseNode(node, folder));
    return parts;
  } catch (const YAML::Exception& error) {
    return bad(fmt::format("line {}: not valid YAML from here on; see docs/gaits.md", error.mark.line + 1));
  } catch (const InvalidArgument& error) {
    return bad(error.what());
  }
}

}  // namespace

DataShape SequenceFileShape() {
  WalkCommand command;
  DataShape part = shapes::Object({{"gait", shapes::Text(), "A gait, as for --gait, or 'stand'."}});
  for (const OptionField& field : FieldsOf(command)) part.members.push_back(shapes::Field(field));
  return shapes::List(part, 1);
}

std::string SequenceFileOf(const std::string& text) {
  const bool parts = text.find_first_of(";=") != std::string::npos;
  return !parts && (text.ends_with(".yaml") || text.ends_with(".yml")) ? text : "";
}

Result<std::vector<AskedPart>> ReadSequence(const std::string& text) {
  const std::string file = SequenceFileOf(text);
  if (!file.empty()) return ReadFileOfParts(file);
  try {
    return ParseParts(text);
  } catch (const InvalidArgument& error) {
    return Failure{FailureKind::kBadInput, FailureCode::kSequence, "ReadSequence", error.what(), {}};
  }
}

}  // namespace gaitwright
