// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/base/options_file.h"

#include <fmt/format.h>

#include <algorithm>

#include "kinematics/base/file.h"
#include "kinematics/base/strict_yaml_internal.h"

namespace gaitwright {
namespace {

OptionTexts ReadEntries(const YAML::Node& root, OptionFields& fields) {
  OptionTexts texts;
  const YamlMap map(root, "the file of options");
  for (const YamlMap::Entry& entry : map.entries()) {
    const std::string value = TextOf(entry.value, fmt::format("option '{}'", entry.key));
    try {
      SetOption(fields, entry.key, value);
    } catch (const InvalidArgument& error) {
      RefuseYaml(entry.key_node, error.what());
    }
    const auto field = std::find_if(fields.begin(), fields.end(), [&](const auto& f) { return f.key == entry.key; });
    texts.emplace_back(entry.key, OptionText(*field));
  }
  return texts;
}

}  // namespace

Result<OptionTexts> LoadOptionsFile(const std::string& path, OptionFields fields) {
  const Result<std::string> text = ReadFile(path);
  if (!text) return text.failure();
  const auto bad = [&](const std::string& message) {
    return Failure{FailureKind::kBadInput,
                   FailureCode::kOptionsFile,
                   "LoadOptionsFile",
                   fmt::format("'{}', {}", path, message),
                   {"write each line as KEY: VALUE, with the keys of --list-options=all"}};
  };
  try {
    const YAML::Node root = LoadYaml(*text);
    if (!root.IsMap() || root.size() == 0) return bad("line 1: contains no options; a map of keys is needed");
    return ReadEntries(root, fields);
  } catch (const YAML::Exception& error) {
    return bad(fmt::format("line {}: not valid YAML from here on", error.mark.line + 1));
  } catch (const InvalidArgument& error) {
    return bad(error.what());
  }
}

}  // namespace gaitwright
