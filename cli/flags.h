// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/verb.h"
#include "kinematics/base/options.h"

namespace gaitwright::cli {

/// A flag with a text that must not be empty; `type` stands after it in the help.
Flag AddText(Verb verb, std::string_view flag, std::string_view type, std::string& target, std::string_view help);

/// A flag with a finite number; `unit` stands after it in the help.
Flag AddNumber(Verb verb, std::string_view flag, std::string_view unit, double& target, std::string_view help);
Flag AddNumber(Verb verb, std::string_view flag, std::string_view unit, std::optional<double>& target,
               std::string_view help);

/// A flag with a whole number from `lowest` up.
Flag AddWholeNumber(Verb verb, std::string_view flag, int lowest, int& target, std::string_view help);
Flag AddWholeNumber(Verb verb, std::string_view flag, int lowest, std::optional<int>& target, std::string_view help);

/// A flag that gives the option of that key.
struct KeyedFlag {
  Flag flag;
  std::string key;
};

/// A flag for one field of `fields`, which gives its unit, range, default and meaning. @throws InvalidArgument when no
/// field has that key.
Flag AddField(Verb verb, std::string_view flag, const OptionFields& fields, std::string_view key);

/// A flag --list-options[=all], which prints the basic (or all) options of --set, as JSON if `json`, and ends.
void AddOptionList(Verb verb, const OptionFields& fields, const bool& json);

/// Applies every `flag` key=value to the fields. @throws InvalidArgument on a key that none has (the nearest is named)
/// and on one that is given twice.
void ApplySets(const std::string& flag, const std::vector<std::string>& sets, OptionFields fields);

}  // namespace gaitwright::cli
