// SPDX-License-Identifier: BSD-3-Clause
// The file that says how the columns of another file are called.
#include <fmt/format.h>

#include <cmath>

#include "kinematics/base/file.h"
#include "kinematics/base/strict_yaml_internal.h"
#include "workflows/exchange/motion_columns.h"

namespace gaitwright {
namespace {

/// The keys that are options too.
const std::vector<std::string> kUnits = {"quaternion_order", "angle_unit", "length_unit", "time_unit"};

ColumnNames Parsed(const YAML::Node& root, ImportOptions& options) {
  const YamlMap map(root, "the file",
                    {"columns", "scale", "ignore", "quaternion_order", "angle_unit", "length_unit", "time_unit"});
  ColumnNames names;
  if (const YAML::Node* columns = map.Find("columns")) {
    const YamlMap entries(*columns, "columns");
    for (const auto& entry : entries.entries()) {
      names.ours[entry.key] = TextOf(entry.value, "column '" + entry.key + "'");
      if (names.ours[entry.key].empty()) RefuseYaml(entry.value, "column '" + entry.key + "' has no name of ours");
    }
  }
  if (const YAML::Node* scale = map.Find("scale")) {
    const YamlMap entries(*scale, "scale");
    for (const auto& entry : entries.entries()) {
      const double factor = NumberOf(entry.value, "scale of '" + entry.key + "'", -1e12, 1e12);
      if (factor == 0.0) RefuseYaml(entry.value, "scale of '" + entry.key + "' is 0; any other number is accepted");
      names.scale[entry.key] = factor;
    }
  }
  if (const YAML::Node* ignore = map.Find("ignore")) {
    for (const YAML::Node& name : ListOf(*ignore, "ignore")) names.ignored.push_back(TextOf(name, "a name in ignore"));
  }
  OptionFields fields = options.Fields();
  ImportOptions usual;
  const OptionTexts defaults = TextsOf(usual.Fields());
  for (const std::string& key : kUnits) {
    const YAML::Node* value = map.Find(key);
    if (value == nullptr) continue;
    for (std::size_t i = 0; i < fields.size(); ++i) {
      if (fields[i].key != key || OptionText(fields[i]) != defaults[i].second) continue;
      try {
        SetOption(fields, key, TextOf(*value, key));
      } catch (const InvalidArgument& error) {
        RefuseYaml(*value, error.what());
      }
    }
  }
  return names;
}

}  // namespace

Result<ColumnNames> ReadColumnNames(const std::string& path, ImportOptions& options) {
  const Result<std::string> text = ReadFile(path);
  if (!text) return text.failure();
  const auto refused = [&](const std::string& why) {
    return Failure{FailureKind::kBadInput, "columns_file", "ReadColumnNames", fmt::format("'{}': {}", path, why), {}};
  };
  try {
    return Parsed(LoadYaml(*text), options);
  } catch (const InvalidArgument& error) {
    return refused(error.what());
  } catch (const YAML::Exception& error) {
    return refused(fmt::format("line {}: {}", error.mark.line + 1, error.msg));
  }
}

}  // namespace gaitwright
