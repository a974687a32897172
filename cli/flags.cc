// SPDX-License-Identifier: BSD-3-Clause
#include "cli/flags.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <string_view>

#include "cli/json_text_internal.h"
#include "cli/listed_options.h"
#include "cli/numbers.h"
#include "cli/word_list.h"

namespace gaitwright::cli {
namespace {

const OptionField& FieldOf(const OptionFields& fields, std::string_view key) {
  const auto field = std::find_if(fields.begin(), fields.end(), [&](const auto& f) { return f.key == key; });
  if (field == fields.end())
    throw InvalidArgument(fmt::format("internal error: a flag names option '{}', which does not exist", key));
  return *field;
}

/// "Coefficient everywhere. From 0 to 10; default 0."
std::string HelpOf(const OptionField& field) {
  if (!field.choices.empty()) return fmt::format("{} Default {}.", field.meaning, OptionText(field));
  return fmt::format("{} From {} to {}; default {}.", field.meaning, field.lowest, field.highest, OptionText(field));
}

Flag AcceptWholeNumbers(Flag flag, int lowest) {
  const auto check = [lowest](const std::string& text) {
    return NotAWholeNumber(text, lowest, std::numeric_limits<int>::max());
  };
  return flag.SetType("N").Check(check);
}

}  // namespace

std::string AcceptedOf(const OptionField& field) {
  if (!field.choices.empty()) return JoinWords(field.choices, ", ");
  if (std::holds_alternative<bool*>(field.target)) return "true, false";
  if (std::holds_alternative<std::string*>(field.target)) return "text";
  return fmt::format("{} to {}", field.lowest, field.highest);
}

OptionFields BasicsFirst(OptionFields fields, bool all) {
  const auto advanced =
      std::stable_partition(fields.begin(), fields.end(), [](const OptionField& field) { return !field.advanced; });
  if (!all) fields.erase(advanced, fields.end());
  return fields;
}

void PrintOptions(const OptionFields& fields, bool as_json) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const OptionField& field : fields) {
    const std::string value = OptionText(field), range = AcceptedOf(field);
    const std::string unit = field.unit.empty() || field.unit == "1" ? "" : " " + field.unit;
    list.push_back({{"key", field.key},
                    {"default", value},
                    {"unit", field.unit},
                    {"accepted", range},
                    {"advanced", field.advanced},
                    {"meaning", field.meaning}});
    if (!as_json) fmt::print("{} = {}{}  ({})\n    {}\n", field.key, value, unit, range, field.meaning);
  }
  if (as_json) PrintJson(nlohmann::ordered_json{{"options", list}});
}

void AddOptionFlags(Verb verb, const OptionFields& fields, std::vector<std::string>& sets, const bool& json) {
  constexpr std::string_view group = "Options by key";
  verb.AddValue("--set", sets,
                "Set an option by its key (see --list-options); may be repeated, each key once. Overrides flags.")
      .SetType("KEY=VALUE")
      .Repeat()
      .SetGroup(group);
  const auto ask = [fields, &json](const std::string& which) {
    if (which != "true" && which != "all")
      throw InvalidArgument(fmt::format("'{}' is not accepted; accepted: all", which));
    throw ListedOptions(BasicsFirst(fields, which == "all"), json);
  };
  verb.AddSwitchReader("--list-options", ask,
                       "Print the basic keys of --set with their units, ranges and defaults; --list-options=all "
                       "prints the advanced keys too.")
      .SetGroup(group);
}

Flag AddText(Verb verb, std::string_view flag, std::string_view type, std::string& target, std::string_view help) {
  const auto check = [](const std::string& text) { return std::string(text.empty() ? "it is empty" : ""); };
  return verb.AddValue(flag, target, help).SetType(type).Check(check);
}

Flag AddNumber(Verb verb, std::string_view flag, std::string_view unit, double& target, std::string_view help) {
  return verb.AddValue(flag, target, help).SetType(unit).Check(NotANumber);
}

Flag AddNumber(Verb verb, std::string_view flag, std::string_view unit, std::optional<double>& target,
               std::string_view help) {
  return verb.AddValue(flag, target, help).SetType(unit).Check(NotANumber);
}

Flag AddWholeNumber(Verb verb, std::string_view flag, int lowest, int& target, std::string_view help) {
  return AcceptWholeNumbers(verb.AddValue(flag, target, help), lowest);
}

Flag AddWholeNumber(Verb verb, std::string_view flag, int lowest, std::optional<int>& target, std::string_view help) {
  return AcceptWholeNumbers(verb.AddValue(flag, target, help), lowest);
}

Flag AddField(Verb verb, std::string_view flag, const OptionFields& fields, std::string_view key) {
  const OptionField field = FieldOf(fields, key);
  const auto set = [field](const std::string& text) {
    OptionFields one = {field};
    SetOption(one, field.key, text);
  };
  const std::string type = field.unit.empty() || field.unit == "1" ? "NUMBER" : field.unit;
  return verb.AddReader(flag, set, HelpOf(field)).SetType(field.choices.empty() ? type : JoinWords(field.choices, "|"));
}

void ApplySets(const std::string& flag, const std::vector<std::string>& sets, OptionFields fields) {
  std::set<std::string> seen;
  for (const std::string& set : sets) {
    const std::size_t equals = set.find('=');
    if (equals == std::string::npos) {
      throw InvalidArgument(fmt::format("{}: '{}' has no '='; key=value is needed", flag, set));
    }
    const std::string key = set.substr(0, equals);
    if (!seen.insert(key).second)
      throw InvalidArgument(fmt::format("{}: '{}' is given twice; leave one of them out", flag, key));
    SetOption(fields, key, set.substr(equals + 1));
  }
}

}  // namespace gaitwright::cli
