// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "kinematics/base/options.h"

namespace gaitwright::cli {

/// A flag with a text that must not be empty; `type` stands after it in the help.
CLI::Option* AddText(CLI::App& verb, const std::string& flag, const std::string& type, std::string& target,
                     const std::string& help);

/// Why a text is no finite number, or "" when it is one.
std::string NotANumber(const std::string& text);

/// Why a text is no whole number from `lowest` to `highest`, or "" when it is one.
std::string NotAWholeNumber(const std::string& text, std::int64_t lowest,
                            std::int64_t highest = std::numeric_limits<std::int64_t>::max());

/// A flag with a finite number; `unit` stands after it in the help. Target: double or std::optional<double>.
template <class Target>
CLI::Option* AddNumber(CLI::App& verb, const std::string& flag, const std::string& unit, Target& target,
                       const std::string& help) {
  return verb.add_option(flag, target, help)->type_name(unit)->check(NotANumber);
}

/// A flag with a whole number from `lowest` up. Target: an int or std::optional of one.
template <class Target>
CLI::Option* AddWholeNumber(CLI::App& verb, const std::string& flag, int lowest, Target& target,
                            const std::string& help) {
  static_assert(std::is_same_v<Target, int> || std::is_same_v<Target, std::optional<int>>);
  const auto check = [lowest](const std::string& text) {
    return NotAWholeNumber(text, lowest, std::numeric_limits<int>::max());
  };
  return verb.add_option(flag, target, help)->type_name("N")->check(check);
}

/// A flag that gives the option of that key.
struct KeyedFlag {
  const CLI::Option* flag;
  std::string key;
};

/// A flag for one field of `fields`, which gives its unit, range, default and meaning. @throws InvalidArgument when no
/// field has that key.
CLI::Option* AddField(CLI::App& verb, const std::string& flag, const OptionFields& fields, const std::string& key);

/// A flag --list-options, which prints what --set can set (with --json, whose place `json` is, as an object) and ends.
void AddOptionList(CLI::App& verb, const OptionFields& fields, const bool& json);

/// Applies every `flag` key=value to the fields. @throws InvalidArgument on a key that none has (the nearest is named)
/// and on one that is given twice.
void ApplySets(const std::string& flag, const std::vector<std::string>& sets, OptionFields fields);

/// Comma-separated numbers. @throws InvalidArgument naming the flag.
std::vector<double> ParseNumbers(const std::string& flag, const std::string& text, std::size_t count);

}  // namespace gaitwright::cli
