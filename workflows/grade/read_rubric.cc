// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "kinematics/base/file.h"
#include "kinematics/base/nearest_name.h"
#include "kinematics/base/strict_yaml_internal.h"
#include "workflows/grade/read_part_internal.h"
#include "workflows/grade/rubric_shape.h"

namespace gaitwright {
namespace {

constexpr double kPointsApart = 1e-6;
constexpr std::size_t kLongestName = 60;

bool IsWord(const std::string& text) {
  const auto good = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  return !text.empty() && text.size() <= kLongestName && std::all_of(text.begin(), text.end(), good) &&
         std::isalpha(static_cast<unsigned char>(text.front())) != 0;
}

/// Whether a text is a plain file name: without folders and not hidden.
bool IsFileName(const std::string& text) {
  return !text.empty() && text.front() != '.' && text.find('/') == std::string::npos && text.size() <= 255;
}

RubricPartKind KindAt(const YamlMap& map) {
  map.Require({"kind"});
  const std::string word = map.Text("kind");
  const std::vector<std::string>& names = PartKindNames();
  const auto at = std::find(names.begin(), names.end(), word);
  if (at == names.end())
    RefuseYaml(*map.Find("kind"), fmt::format("there is no kind of part '{}'{}", word, NearestOrAll(word, names)));
  return static_cast<RubricPartKind>(at - names.begin());
}

void ReadLimits(const YAML::Node& node, RubricPart& part) {
  OptionFields fields = part.limits.Fields();
  const DataShape shape = LimitsShape(part.kind);
  const YamlMap map(node, "'limits'", shape);
  for (const YamlMap::Entry& entry : map.entries()) {
    if (entry.key == "motion_s" || entry.key == "judge_s") {
      (entry.key == "motion_s" ? part.motion.longest_motion_s : part.judge_s) = *map.InRange(entry.key);
      continue;
    }
    try {
      SetOption(fields, entry.key, TextOf(entry.value, fmt::format("'{}'", entry.key)));
    } catch (const InvalidArgument& error) {
      RefuseYaml(entry.value, error.what());
    }
  }
}

Check ReadCheck(const YAML::Node& node, RubricPartKind kind) {
  const DataShape shape = CheckShape(kind);
  const YamlMap map(node, "a check", shape);
  Check check;
  check.measure = map.Text("measure");
  check.points = *map.InRange("points");
  const MeasureRule rule = MeasureAt(*map.Find("measure"), check.measure, kind);
  check.higher_is_better = rule.higher_is_better;
  const std::optional<double> full = map.InRange("full_at");
  if (!full && !rule.usual_full_at)
    RefuseYaml(node, fmt::format("the check of '{}' lacks 'full_at', the value for full points", check.measure));
  check.full_at = full ? *full : *rule.usual_full_at;
  check.none_at = map.InRange("none_at");
  if (check.none_at && *check.none_at == check.full_at)
    RefuseYaml(node, fmt::format("'full_at' and 'none_at' are both {}; leave 'none_at' out for all or nothing",
                                 check.full_at));
  if (check.none_at) check.higher_is_better = check.full_at > *check.none_at;
  return check;
}

void ReadChecks(const YamlMap& map, RubricPart& part) {
  const YAML::Node* list = map.Find("checks");
  if (list == nullptr) {
    part.checks = {{"share_right", part.points, 1.0, 0.0, true}};
    return;
  }
  double sum = 0.0;
  for (const YAML::Node& one : ListOf(*list, "'checks'")) {
    part.checks.push_back(ReadCheck(one, part.kind));
    sum += part.checks.back().points;
  }
  if (std::abs(sum - part.points) > kPointsApart)
    RefuseYaml(*list, fmt::format("the checks of part '{}' have {} points in all, but the part has {}", part.name, sum,
                                  part.points));
}

void ReadNames(const YamlMap& map, RubricPart& part) {
  part.name = map.Text("name");
  if (!IsWord(part.name))
    RefuseYaml(*map.Find("name"), fmt::format("a part is named '{}'; a name has letters, digits and '_', begins with a "
                                              "letter, and has at most {} characters",
                                              part.name, kLongestName));
  part.title = map.Find("title") == nullptr ? part.name : map.Text("title");
  part.file = map.Text("file");
  if (!IsFileName(part.file))
    RefuseYaml(*map.Find("file"), fmt::format("the file of part '{}' is '{}'; the name of a file in the student's "
                                              "folder is needed, without folders",
                                              part.name, part.file));
  part.points = *map.InRange("points");
}

RubricPart ReadPart(const YAML::Node& node) {
  RubricPart part;
  part.kind = KindAt(YamlMap(node, "a part"));
  const std::string what = fmt::format("a part of kind '{}'", PartKindNames()[static_cast<std::size_t>(part.kind)]);
  const DataShape shape = PartShape(part.kind);
  const YamlMap map(node, what, shape);
  ReadNames(map, part);
  if (const YAML::Node* limits = map.Find("limits")) ReadLimits(*limits, part);
  PlaysMotions(part.kind) ? ReadMotionSetup(map, node, part) : ReadQuestionSetup(map, node, part);
  if (RunsCode(part.kind)) ReadCodeSetup(map, part);
  ReadChecks(map, part);
  return part;
}

Rubric ReadRoot(const YAML::Node& root) {
  const DataShape shape = RubricShape();
  const YamlMap map(root, "the rubric", shape);
  Rubric rubric;
  rubric.title = map.Text("title");
  const std::vector<YAML::Node> parts = ListOf(*map.Find("parts"), "'parts'");
  const DataShape& accepted = shape.At("parts");
  if (parts.size() < accepted.least || parts.size() > accepted.most)
    RefuseYaml(*map.Find("parts"),
               fmt::format("there are {} parts; {} to {} are accepted", parts.size(), accepted.least, accepted.most));
  for (const YAML::Node& node : parts) {
    rubric.parts.push_back(ReadPart(node));
    for (std::size_t before = 0; before + 1 < rubric.parts.size(); ++before) {
      if (rubric.parts[before].name == rubric.parts.back().name)
        RefuseYaml(node, fmt::format("two parts are named '{}'", rubric.parts.back().name));
    }
  }
  return rubric;
}

}  // namespace

Result<Rubric> ReadRubric(const std::string& text, const std::string& source) {
  const auto bad = [&](const std::string& message) {
    return Failure{FailureKind::kBadInput,
                   FailureCode::kRubric,
                   "ReadRubric",
                   fmt::format("'{}', {}", source, message),
                   {"docs/grading.md lists all keys"}};
  };
  try {
    const YAML::Node root = LoadYaml(text);
    if (!root.IsMap()) return bad("line 1: contains no rubric; a map with 'title' and 'parts' is needed");
    return ReadRoot(root);
  } catch (const YAML::Exception& error) {
    return bad(fmt::format("line {}: not valid YAML from here on", error.mark.line + 1));
  } catch (const InvalidArgument& error) {
    return bad(error.what());
  }
}

Result<Rubric> LoadRubric(const std::string& path) {
  const Result<std::string> text = ReadFile(path);
  if (!text) return text.failure();
  return ReadRubric(*text, path);
}

}  // namespace gaitwright
