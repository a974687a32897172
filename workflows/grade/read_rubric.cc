// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "kinematics/base/file.h"
#include "kinematics/base/nearest_name.h"
#include "kinematics/base/strict_yaml_internal.h"
#include "workflows/grade/read_part_internal.h"

namespace gaitwright {
namespace {

constexpr double kMostPoints = 1e6, kPointsApart = 1e-6, kLargestValue = 1e12;
constexpr std::size_t kMostParts = 200, kLongestName = 60;

/// Keys of every part, of those that ask questions, and of those that play motions.
const std::vector<std::string> kOfAll = {"name", "title", "kind", "file", "points", "limits", "checks"};
const std::vector<std::string> kOfCode = {"function", "library"};
const std::vector<std::string> kOfQuestions = {"reference", "cases", "tolerance", "size", "robot", "inputs"};
const std::vector<std::string> kOfMotions = {"robot", "terrain", "command", "runs", "play", "trials", "disturbances"};

std::vector<std::string> KeysOf(PartKind kind) {
  std::vector<std::string> keys = kOfAll;
  const auto add = [&](const std::vector<std::string>& more) { keys.insert(keys.end(), more.begin(), more.end()); };
  if (RunsCode(kind)) add(kOfCode);
  add(PlaysMotions(kind) ? kOfMotions : kOfQuestions);
  if (kind == PartKind::kAnswers) add({"seed"});
  if (PlaysMotions(kind) && kind != PartKind::kController) add({"controller"});
  if (kind == PartKind::kParameters) add({"gait", "options"});
  if (kind == PartKind::kController) add({"gait"});
  if (kind == PartKind::kPlanner) add({"swing_s", "pause_s"});
  return keys;
}

bool IsWord(const std::string& text) {
  const auto good = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  return !text.empty() && text.size() <= kLongestName && std::all_of(text.begin(), text.end(), good) &&
         std::isalpha(static_cast<unsigned char>(text.front())) != 0;
}

/// A plain name of a file: no folder, nothing hidden.
bool IsFileName(const std::string& text) {
  return !text.empty() && text.front() != '.' && text.find('/') == std::string::npos && text.size() <= 255;
}

PartKind KindAt(const YamlMap& map, const YAML::Node& node) {
  map.Require({"kind"});
  const std::string word = map.Text("kind");
  const std::vector<std::string>& names = PartKindNames();
  const auto at = std::find(names.begin(), names.end(), word);
  if (at == names.end())
    RefuseYaml(*map.Find("kind"), fmt::format("there is no kind of part '{}'{}", word, NearestOrAll(word, names)));
  (void)node;
  return static_cast<PartKind>(at - names.begin());
}

void ReadLimits(const YAML::Node& node, RubricPart& part) {
  OptionFields fields = part.limits.Fields();
  std::vector<std::string> known;
  for (const OptionField& field : fields) known.push_back(field.key);
  known.emplace_back("judge_s");
  if (PlaysMotions(part.kind)) known.emplace_back("motion_s");
  const YamlMap map(node, "'limits'", known);
  for (const YamlMap::Entry& entry : map.entries()) {
    if (entry.key == "motion_s" || entry.key == "judge_s") {
      double& limit = entry.key == "motion_s" ? part.motion.longest_motion_s : part.judge_s;
      limit = NumberOf(entry.value, fmt::format("'{}'", entry.key), 0.1, 36000.0);
      continue;
    }
    try {
      SetOption(fields, entry.key, TextOf(entry.value, fmt::format("'{}'", entry.key)));
    } catch (const InvalidArgument& error) {
      RefuseYaml(entry.value, error.what());
    }
  }
}

/// A value that points are given at.
std::optional<double> ValueAt(const YamlMap& map, const std::string& key) {
  const YAML::Node* node = map.Find(key);
  if (node == nullptr) return std::nullopt;
  return NumberOf(*node, fmt::format("'{}'", key), -kLargestValue, kLargestValue);
}

Check ReadCheck(const YAML::Node& node, PartKind kind) {
  const YamlMap map(node, "a check", {"measure", "points", "full_at", "none_at"});
  map.Require({"measure", "points"});
  Check check;
  check.measure = map.Text("measure");
  check.points = NumberOf(*map.Find("points"), "'points'", 0.0, kMostPoints);
  const MeasureRule rule = MeasureAt(*map.Find("measure"), check.measure, kind);
  check.higher_is_better = rule.higher_is_better;
  const std::optional<double> full = ValueAt(map, "full_at");
  if (!full && !rule.usual_full_at)
    RefuseYaml(node, fmt::format("the check of '{}' lacks 'full_at': the value that gets all points", check.measure));
  check.full_at = full ? *full : *rule.usual_full_at;
  check.none_at = ValueAt(map, "none_at");
  if (check.none_at && *check.none_at == check.full_at)
    RefuseYaml(node, fmt::format("'full_at' and 'none_at' are both {}; without 'none_at' it is all or nothing",
                                 check.full_at));
  if (check.none_at) check.higher_is_better = check.full_at > *check.none_at;
  return check;
}

void ReadChecks(const YamlMap& map, const YAML::Node& node, RubricPart& part) {
  const YAML::Node* list = map.Find("checks");
  if (list == nullptr && !PlaysMotions(part.kind)) {
    part.checks = {{"share_right", part.points, 1.0, 0.0, true}};
    return;
  }
  if (list == nullptr) RefuseYaml(node, fmt::format("part '{}' lacks the key 'checks'", part.name));
  double sum = 0.0;
  for (const YAML::Node& one : ListOf(*list, "'checks'")) {
    part.checks.push_back(ReadCheck(one, part.kind));
    sum += part.checks.back().points;
  }
  if (std::abs(sum - part.points) > kPointsApart)
    RefuseYaml(*list,
               fmt::format("the checks of part '{}' are of {} points, the part of {}", part.name, sum, part.points));
}

void ReadNames(const YamlMap& map, const YAML::Node& node, RubricPart& part) {
  map.Require({"name", "file", "points"});
  part.name = map.Text("name");
  if (!IsWord(part.name))
    RefuseYaml(*map.Find("name"), fmt::format("a part is called '{}'; a name has letters, digits and '_', begins with "
                                              "a letter, and is no longer than {}",
                                              part.name, kLongestName));
  part.title = map.Find("title") == nullptr ? part.name : map.Text("title");
  part.file = map.Text("file");
  if (!IsFileName(part.file))
    RefuseYaml(*map.Find("file"), fmt::format("the file of part '{}' is '{}'; the name of a file in the student's "
                                              "folder is needed, without folders",
                                              part.name, part.file));
  part.points = NumberOf(*map.Find("points"), "'points'", 0.0, kMostPoints);
  if (part.points == 0.0) RefuseYaml(*map.Find("points"), fmt::format("part '{}' is of 0 points", part.name));
  (void)node;
}

RubricPart ReadPart(const YAML::Node& node) {
  RubricPart part;
  part.kind = KindAt(YamlMap(node, "a part"), node);
  const std::string what = fmt::format("a part of kind '{}'", PartKindNames()[static_cast<std::size_t>(part.kind)]);
  const YamlMap map(node, what, KeysOf(part.kind));
  ReadNames(map, node, part);
  if (const YAML::Node* limits = map.Find("limits")) ReadLimits(*limits, part);
  PlaysMotions(part.kind) ? ReadMotionSetup(map, node, part) : ReadQuestionSetup(map, node, part);
  if (RunsCode(part.kind)) ReadCodeSetup(map, part);
  ReadChecks(map, node, part);
  return part;
}

Rubric ReadRoot(const YAML::Node& root) {
  const YamlMap map(root, "the rubric", {"title", "parts"});
  map.Require({"title", "parts"});
  Rubric rubric;
  rubric.title = map.Text("title");
  const std::vector<YAML::Node> parts = ListOf(*map.Find("parts"), "'parts'");
  if (parts.empty() || parts.size() > kMostParts)
    RefuseYaml(*map.Find("parts"), fmt::format("there are {} parts; 1 to {} are accepted", parts.size(), kMostParts));
  for (const YAML::Node& node : parts) {
    rubric.parts.push_back(ReadPart(node));
    for (std::size_t before = 0; before + 1 < rubric.parts.size(); ++before) {
      if (rubric.parts[before].name == rubric.parts.back().name)
        RefuseYaml(node, fmt::format("two parts are called '{}'", rubric.parts.back().name));
    }
  }
  return rubric;
}

}  // namespace

Result<Rubric> ReadRubric(const std::string& text, const std::string& source) {
  const auto bad = [&](const std::string& message) {
    return Failure{FailureKind::kBadInput,
                   "rubric",
                   "ReadRubric",
                   fmt::format("'{}', {}", source, message),
                   {"every key stands in docs/grading.md"}};
  };
  try {
    const YAML::Node root = LoadYaml(text);
    if (!root.IsMap()) return bad("line 1: holds no rubric: a map with 'title' and 'parts' is needed");
    return ReadRoot(root);
  } catch (const YAML::Exception& error) {
    return bad(fmt::format("line {}: is no YAML from here on", error.mark.line + 1));
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
