// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/base/options.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "kinematics/base/nearest_name.h"

namespace gaitwright {
namespace {

void CheckNumber(const OptionField& field, double value) {
  if (!std::isfinite(value) || value < field.lowest || value > field.highest) {
    const std::string unit = field.unit.empty() || field.unit == "1" ? "" : " " + field.unit;
    throw InvalidArgument(
        fmt::format("option '{}' is {}{}; accepted: {} to {}", field.key, value, unit, field.lowest, field.highest));
  }
}

template <class Number>
Number Parse(const OptionField& field, const std::string& text, const char* kind) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) {
    throw InvalidArgument(fmt::format("option '{}' is '{}', which is not {}", field.key, text, kind));
  }
  CheckNumber(field, static_cast<double>(value));
  return value;
}

void CheckChoice(const OptionField& field, const std::string& text) {
  if (field.choices.empty() || std::find(field.choices.begin(), field.choices.end(), text) != field.choices.end())
    return;
  throw InvalidArgument(fmt::format("option '{}' is '{}'; accepted: {}", field.key, text, QuotedList(field.choices)));
}

struct Setter {
  const OptionField& field;
  const std::string& text;

  void operator()(double* target) const { *target = Parse<double>(field, text, "a number"); }
  void operator()(int* target) const { *target = Parse<int>(field, text, "a whole number"); }
  void operator()(bool* target) const {
    if (text != "true" && text != "false") {
      throw InvalidArgument(fmt::format("option '{}' is '{}'; accepted: true, false", field.key, text));
    }
    *target = text == "true";
  }
  void operator()(std::string* target) const {
    CheckChoice(field, text);
    *target = text;
  }
};

struct Printer {
  std::string operator()(const double* target) const { return fmt::format("{}", *target); }
  std::string operator()(const int* target) const { return fmt::format("{}", *target); }
  std::string operator()(const bool* target) const { return *target ? "true" : "false"; }
  std::string operator()(const std::string* target) const { return *target; }
};

struct Checker {
  const OptionField& field;

  void operator()(const double* target) const { CheckNumber(field, *target); }
  void operator()(const int* target) const { CheckNumber(field, *target); }
  void operator()(const bool*) const {}
  void operator()(const std::string* target) const { CheckChoice(field, *target); }
};

}  // namespace

std::string QuotedList(const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "'" : ", '") + name + "'";
  return list;
}

void SetOption(OptionFields& fields, const std::string& key, const std::string& text) {
  const auto field = std::find_if(fields.begin(), fields.end(), [&](const auto& f) { return f.key == key; });
  if (field == fields.end()) {
    std::vector<std::string> keys;
    for (const OptionField& f : fields) keys.push_back(f.key);
    throw InvalidArgument(fmt::format("unknown option '{}'{}", key,
                                      NearestOrAll(key, keys, "--list-options=all prints all option keys")));
  }
  std::visit(Setter{*field, text}, field->target);
}

std::string OptionText(const OptionField& field) { return std::visit(Printer{}, field.target); }

OptionTexts TextsOf(const OptionFields& fields) {
  OptionTexts texts;
  for (const OptionField& field : fields) texts.emplace_back(field.key, OptionText(field));
  return texts;
}

std::vector<OptionChange> ChangesFrom(const OptionFields& usual, const OptionTexts& texts) {
  std::vector<OptionChange> changes;
  for (const auto& [key, text] : texts) {
    for (const OptionField& field : usual) {
      if (field.key == key && OptionText(field) != text) changes.push_back({key, text, OptionText(field)});
    }
  }
  return changes;
}

void CheckOptions(const OptionFields& fields) {
  for (const OptionField& field : fields) std::visit(Checker{field}, field.target);
}

OptionFields Prefixed(const std::string& prefix, OptionFields fields) {
  for (OptionField& field : fields) field.key = prefix + "." + field.key;
  return fields;
}

OptionFields WithBasics(const std::vector<std::string>& basics, OptionFields fields) {
  for (OptionField& field : fields) field.advanced = true;
  for (const std::string& key : basics) {
    const auto field = std::find_if(fields.begin(), fields.end(), [&](const auto& f) { return f.key == key; });
    if (field == fields.end())
      throw InvalidArgument(fmt::format("internal error: the basic option '{}' does not exist", key));
    field->advanced = false;
  }
  return fields;
}

OptionFields Joined(std::vector<OptionFields> lists) {
  OptionFields joined;
  for (OptionFields& list : lists) {
    joined.insert(joined.end(), std::make_move_iterator(list.begin()), std::make_move_iterator(list.end()));
  }
  return joined;
}

}  // namespace gaitwright
