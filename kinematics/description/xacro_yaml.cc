// SPDX-License-Identifier: BSD-3-Clause
// Values of YAML files for load_yaml().
#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <map>
#include <numbers>

#include "kinematics/base/non_finite.h"
#include "kinematics/base/strict_yaml_internal.h"
#include "kinematics/base/text.h"
#include "kinematics/description/xacro_expander_internal.h"

namespace gaitwright {
namespace {

constexpr YamlBounds kXacroYaml = {std::size_t{4} << 20, 200000};

/// The units of xacro's YAML in SI, by tag.
const std::map<std::string, double> kXacroUnits = {{"!radians", 1.0},      {"!degrees", std::numbers::pi / 180.0},
                                                   {"!meters", 1.0},       {"!centimeters", 0.01},
                                                   {"!millimeters", 1e-3}, {"!foot", 0.3048},
                                                   {"!feet", 0.3048},      {"!inches", 0.0254}};

bool IsYamlWord(const std::string& word, std::initializer_list<const char*> words) {
  return std::any_of(words.begin(), words.end(), [&](const char* one) { return word == one; });
}

/// The value of a word without quotes: nothing, a truth value, a number or a text, as in YAML 1.1.
XacroValue PlainXacroYaml(const std::string& word) {
  if (IsYamlWord(word, {"", "~", "null", "Null", "NULL"})) return {};
  if (IsYamlWord(word, {"true", "True", "TRUE", "yes", "Yes", "YES", "on", "On", "ON"})) return {true};
  if (IsYamlWord(word, {"false", "False", "FALSE", "no", "No", "NO", "off", "Off", "OFF"})) return {false};
  if (IsYamlWord(word, {".inf", ".Inf", ".INF", "+.inf"})) return {kInfinity};
  if (IsYamlWord(word, {"-.inf", "-.Inf", "-.INF"})) return {-kInfinity};
  if (IsYamlWord(word, {".nan", ".NaN", ".NAN"})) return {kNaN};
  const bool digits = word.find_first_of("0123456789") != std::string::npos;
  if (const auto whole = XacroWholeOf(word)) return {*whole};
  if (const auto real = XacroRealOf(word); real && digits) return {*real};
  return XacroText(word);
}

/// The value of a number with a unit in SI; the number may be an expression.
XacroValue UnitXacroYaml(const YAML::Node& node, double unit, XacroContext& context) {
  const XacroValue value = EvaluateXacro(node.Scalar(), context);
  const auto number = XacroNumber(value);
  if (!number) {
    throw XacroProblem{FailureCode::kXacroYaml, fmt::format("line {}: {} '{}' is not a number", LineOf(node),
                                                            node.Tag(), Shortened(node.Scalar()))};
  }
  return {*number * unit};
}

XacroValue XacroValueOfYaml(const YAML::Node& node, XacroContext& context) {
  context.budget.Spend(4);
  if (node.IsScalar()) {
    const auto unit = kXacroUnits.find(node.Tag());
    if (unit != kXacroUnits.end()) return UnitXacroYaml(node, unit->second, context);
    const bool quoted = node.Tag() == "!" || node.Tag() == "tag:yaml.org,2002:str";
    return quoted ? XacroText(node.Scalar()) : PlainXacroYaml(node.Scalar());
  }
  if (node.IsSequence()) {
    std::vector<XacroValue> items;
    for (const YAML::Node& item : node) items.push_back(XacroValueOfYaml(item, context));
    return XacroListOf(std::move(items), context.budget);
  }
  if (!node.IsMap()) return {};
  std::vector<std::pair<XacroValue, XacroValue>> entries;
  for (const auto& entry : node) {
    if (!entry.first.IsScalar())
      throw XacroProblem{FailureCode::kXacroYaml, fmt::format("line {}: a key is not a word", LineOf(entry.first))};
    entries.emplace_back(XacroValueOfYaml(entry.first, context), XacroValueOfYaml(entry.second, context));
  }
  return XacroDictOf(std::move(entries), context.budget);
}

}  // namespace

XacroValue XacroFromYaml(const std::string& text, XacroContext& context) {
  context.budget.Spend(1 + text.size() / 8);
  try {
    return XacroValueOfYaml(LoadYaml(text, kXacroYaml), context);
  } catch (const YAML::Exception& error) {
    throw XacroProblem{FailureCode::kXacroYaml,
                       fmt::format("line {}: it is not YAML: {}", error.mark.line + 1, error.msg)};
  } catch (const InvalidArgument& error) {
    throw XacroProblem{FailureCode::kXacroYaml, error.what()};
  }
}

}  // namespace gaitwright
