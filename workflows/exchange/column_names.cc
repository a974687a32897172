// SPDX-License-Identifier: BSD-3-Clause
// Reads the file that maps the column names of another file.
#include <fmt/format.h>

#include <cmath>

#include "kinematics/base/file.h"
#include "kinematics/base/strict_yaml_internal.h"
#include "workflows/exchange/file_shapes.h"
#include "workflows/exchange/motion_columns.h"

namespace gaitwright {
namespace {

constexpr double kLargestScale = 1e12;

/// Takes the order or a unit from the file; a different value elsewhere is refused.
void TakeUnit(const std::string& key, const YAML::Node& value, ImportOptions& options) {
  ImportOptions usual, filed;
  OptionFields of_file = filed.UnitFields();
  try {
    SetOption(of_file, key, TextOf(value, key));
  } catch (const InvalidArgument& error) {
    RefuseYaml(value, error.what());
  }
  const OptionTexts defaults = TextsOf(usual.UnitFields()), said = TextsOf(of_file),
                    given = TextsOf(options.UnitFields());
  for (std::size_t i = 0; i < said.size(); ++i) {
    if (said[i].first != key || said[i] == defaults[i] || given[i] == said[i]) continue;
    if (given[i] != defaults[i]) {
      RefuseYaml(value, fmt::format("'{}' is '{}' here but '{}' on the command line; set it once", key, said[i].second,
                                    given[i].second));
    }
    OptionFields fields = options.UnitFields();
    SetOption(fields, key, said[i].second);
  }
}

ColumnNames Parsed(const YAML::Node& root, ImportOptions& options) {
  const DataShape shape = ColumnNamesShape();
  const YamlMap map(root, "the file", shape);
  ColumnNames names;
  if (const YAML::Node* list = map.Find("names")) {
    for (const YAML::Node& name : ListOf(*list, "names")) names.in_order.push_back(TextOf(name, "a name in names"));
  }
  if (const YAML::Node* columns = map.Find("columns")) {
    const YamlMap entries(*columns, "columns");
    for (const auto& entry : entries.entries()) {
      names.ours[entry.key] = TextOf(entry.value, "column '" + entry.key + "'");
      if (names.ours[entry.key].empty())
        RefuseYaml(entry.value, "column '" + entry.key + "' is not mapped to a name of this program");
    }
  }
  if (const YAML::Node* scale = map.Find("scale")) {
    const YamlMap entries(*scale, "scale");
    for (const auto& entry : entries.entries()) {
      const double factor = NumberOf(entry.value, "scale of '" + entry.key + "'", -kLargestScale, kLargestScale);
      if (factor == 0.0) RefuseYaml(entry.value, "scale of '" + entry.key + "' is 0; any other number is accepted");
      names.scale[entry.key] = factor;
    }
  }
  if (const YAML::Node* ignore = map.Find("ignore")) {
    for (const YAML::Node& name : ListOf(*ignore, "ignore")) names.ignored.push_back(TextOf(name, "a name in ignore"));
  }
  for (const OptionField& unit : ImportOptions().UnitFields()) {
    if (const YAML::Node* value = map.Find(unit.key)) TakeUnit(unit.key, *value, options);
  }
  return names;
}

}  // namespace

DataShape ColumnNamesShape() {
  using namespace shapes;
  DataShape shape = Object(
      {Optional("names", List(Text()), "Names of the columns in their order, of a file without a line of names."),
       Optional("columns", MapOf(Text()), "Map of the file's column names to the names of this program."),
       Optional("scale", MapOf(Number(-kLargestScale, kLargestScale)),
                "Factor for the values of a column, by the file's column name; not 0."),
       Optional("ignore", List(Text()), "Columns to ignore, by the file's column names.")});
  ImportOptions options;
  for (const OptionField& unit : options.UnitFields()) shape.members.push_back(Field(unit));
  return shape;
}

Result<ColumnNames> ReadColumnNames(const std::string& path, ImportOptions& options) {
  const Result<std::string> text = ReadFile(path);
  if (!text) return text.failure();
  const auto refused = [&](const std::string& why) {
    return Failure{
        FailureKind::kBadInput, FailureCode::kColumnsFile, "ReadColumnNames", fmt::format("'{}': {}", path, why), {}};
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
