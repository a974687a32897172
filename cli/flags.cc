// SPDX-License-Identifier: BSD-3-Clause
#include "cli/flags.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "cli/listed_options.h"

namespace gaitwright::cli {
namespace {

/// Reads the whole text as a number. @return how that went: no error, beyond what the type holds, or no number.
template <class Number>
std::errc ReadWhole(const std::string& text, Number& value) {
  const char* begin = text.data() + (text.size() > 1 && text[0] == '+' && text[1] != '-' ? 1 : 0);
  const auto [end, error] = std::from_chars(begin, text.data() + text.size(), value);
  return end == text.data() + text.size() ? error : std::errc::invalid_argument;
}

/// The same; false for what the type does not hold too.
template <class Number>
bool Read(const std::string& text, Number& value) {
  return ReadWhole(text, value) == std::errc{};
}

const OptionField& FieldOf(const OptionFields& fields, const std::string& key) {
  const auto field = std::find_if(fields.begin(), fields.end(), [&](const auto& f) { return f.key == key; });
  if (field == fields.end()) throw InvalidArgument(fmt::format("there is no option '{}' to make a flag of", key));
  return *field;
}

/// "Coefficient everywhere. From 0 to 10; default 0."
std::string HelpOf(const OptionField& field) {
  if (!field.choices.empty()) return fmt::format("{} Default {}.", field.meaning, OptionText(field));
  return fmt::format("{} From {} to {}; default {}.", field.meaning, field.lowest, field.highest, OptionText(field));
}

}  // namespace

std::string AcceptedOf(const OptionField& field) {
  if (!field.choices.empty()) return fmt::format("{}", fmt::join(field.choices, ", "));
  if (std::holds_alternative<bool*>(field.target)) return "true, false";
  if (std::holds_alternative<std::string*>(field.target)) return "text";
  return fmt::format("{} to {}", field.lowest, field.highest);
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
                    {"meaning", field.meaning}});
    if (!as_json) fmt::print("{} = {}{}  ({})\n    {}\n", field.key, value, unit, range, field.meaning);
  }
  if (as_json) fmt::print("{}\n", nlohmann::ordered_json{{"options", list}}.dump(2));
}

void AddOptionList(CLI::App& verb, const OptionFields& fields, const bool& json) {
  const auto ask = [fields, &json] { throw ListedOptions(fields, json); };
  verb.add_flag_callback("--list-options", ask, "Print every key of --set with its unit, range and default.")
      ->group("Flags of every verb");
}

CLI::Option* AddText(CLI::App& verb, const std::string& flag, const std::string& type, std::string& target,
                     const std::string& help) {
  const auto check = [](const std::string& text) { return std::string(text.empty() ? "it is empty" : ""); };
  return verb.add_option(flag, target, help)->type_name(type)->check(check);
}

std::string NotANumber(const std::string& text) {
  double value = 0.0;
  return Read(text, value) && std::isfinite(value) ? "" : fmt::format("'{}' is not a finite number", text);
}

std::string NotAWholeNumber(const std::string& text, std::int64_t lowest, std::int64_t highest) {
  std::int64_t value = 0;
  const std::errc error = ReadWhole(text, value);
  if (error == std::errc::invalid_argument) return fmt::format("'{}' is not a whole number", text);
  const bool beyond = error == std::errc::result_out_of_range;
  if (beyond ? text.front() == '-' : value < lowest)
    return fmt::format("{} is too little; {} or more is accepted", text, lowest);
  return beyond || value > highest ? fmt::format("{} is too much; accepted: {} to {}", text, lowest, highest) : "";
}

CLI::Option* AddField(CLI::App& verb, const std::string& flag, const OptionFields& fields, const std::string& key) {
  const OptionField field = FieldOf(fields, key);
  const auto set = [flag, field](const std::string& text) {
    OptionFields one = {field};
    try {
      SetOption(one, field.key, text);
    } catch (const InvalidArgument& error) {
      throw CLI::ValidationError(flag, error.what());
    }
  };
  const std::string type = field.unit.empty() || field.unit == "1" ? "NUMBER" : field.unit;
  return verb.add_option_function<std::string>(flag, set, HelpOf(field))
      ->type_name(field.choices.empty() ? type : fmt::format("{}", fmt::join(field.choices, "|")));
}

void ApplySets(const std::string& flag, const std::vector<std::string>& sets, OptionFields fields) {
  std::set<std::string> seen;
  for (const std::string& set : sets) {
    const std::size_t equals = set.find('=');
    if (equals == std::string::npos) {
      throw InvalidArgument(fmt::format("{}: '{}' has no '='; key=value is needed", flag, set));
    }
    if (fields.empty()) throw InvalidArgument(fmt::format("{} {}: this verb has no options to set", flag, set));
    const std::string key = set.substr(0, equals);
    if (!seen.insert(key).second)
      throw InvalidArgument(fmt::format("{}: '{}' is given twice; leave one of them out", flag, key));
    SetOption(fields, key, set.substr(equals + 1));
  }
}

std::vector<double> ParseNumbers(const std::string& flag, const std::string& text, std::size_t count) {
  std::vector<double> numbers;
  std::istringstream stream(text);
  for (std::string word; std::getline(stream, word, ',');) {
    double value = 0.0;
    if (!Read(word, value) || !std::isfinite(value))
      throw InvalidArgument(fmt::format("{}: '{}' is not a finite number", flag, word));
    numbers.push_back(value);
  }
  if (numbers.size() != count || text.ends_with(',')) {
    throw InvalidArgument(
        fmt::format("{}: {} numbers are needed, separated by commas; '{}' has {}", flag, count, text, numbers.size()));
  }
  return numbers;
}

}  // namespace gaitwright::cli
