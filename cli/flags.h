// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/verb.h"
#include "kinematics/base/options.h"

namespace gaitwright::cli {

/// Adds a flag with a text that must not be empty; the help shows `type` after the flag.
Flag AddText(Verb verb, std::string_view flag, std::string_view type, std::string& target, std::string_view help);

/// Adds a flag with a finite number; the help shows `unit` after the flag.
Flag AddNumber(Verb verb, std::string_view flag, std::string_view unit, double& target, std::string_view help);
Flag AddNumber(Verb verb, std::string_view flag, std::string_view unit, std::optional<double>& target,
               std::string_view help);

/// Adds a flag with a whole number of at least `lowest`.
Flag AddWholeNumber(Verb verb, std::string_view flag, int lowest, int& target, std::string_view help);
Flag AddWholeNumber(Verb verb, std::string_view flag, int lowest, std::optional<int>& target, std::string_view help);

/// A flag that sets the option with this key.
struct KeyedFlag {
  Flag flag;
  std::string key;
};

/// Adds a flag for one field of `fields`; its help has the field's unit, range, default and meaning. @throws
/// InvalidArgument if no field has that key.
Flag AddField(Verb verb, std::string_view flag, const OptionFields& fields, std::string_view key);

/// Adds the flags of a verb with options: --set, which collects its values in `sets`, and --list-options[=all], which
/// prints the basic (or all) options of --set, as JSON if `json`, and exits.
void AddOptionFlags(Verb verb, const OptionFields& fields, std::vector<std::string>& sets, const bool& json);

/// Applies every `flag` key=value to the fields. @throws InvalidArgument for an unknown key (the message names the
/// nearest one) and for a key that is given twice.
void ApplySets(const std::string& flag, const std::vector<std::string>& sets, OptionFields fields);

}  // namespace gaitwright::cli
