// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "kinematics/base/result.h"

namespace gaitwright {

/// One field of an options struct: where it is, its key, unit, range and meaning. Made by a struct's `Fields()`.
///
///     struct SwingOptions {
///       double height_m = 0.05;
///       std::vector<OptionField> Fields() { return {{"height_m", &height_m, "m", 0.0, 1.0, "Lift of the sole."}}; }
///     };
///
/// The list is the only place that names a field: YAML, `--set`, the docs, provenance and range checks read it.
struct OptionField {
  using Target = std::variant<double*, int*, bool*, std::string*>;

  std::string key;  ///< ends in its SI unit
  Target target;
  std::string unit;
  double lowest = -std::numeric_limits<double>::infinity();
  double highest = std::numeric_limits<double>::infinity();
  std::string meaning;
  std::vector<std::string> choices = {};  ///< for text: the values that are accepted; empty for any
  bool advanced = false;                  ///< listed only when all options are asked for; see WithBasics
};

using OptionFields = std::vector<OptionField>;

/// "'a', 'b', 'c'": for messages that list what exists.
std::string QuotedList(const std::vector<std::string>& names);

/// Sets the field `key` from its text. @throws InvalidArgument on an unknown key (names the nearest), a value that does
/// not parse, is not finite or lies outside the range.
void SetOption(OptionFields& fields, const std::string& key, const std::string& text);

/// The field's present value as text that SetOption reads back exactly.
std::string OptionText(const OptionField& field);

/// @throws InvalidArgument naming the first field that is not finite or out of its range.
void CheckOptions(const OptionFields& fields);

/// `fields` with `prefix` + '.' before every key, so that several structs share one namespace.
OptionFields Prefixed(const std::string& prefix, OptionFields fields);

/// `fields`, all of them advanced but those with a key of `basics`, which users need first.
/// @throws InvalidArgument when no field has one of these keys.
OptionFields WithBasics(const std::vector<std::string>& basics, OptionFields fields);

/// Options as they are written down: key and text.
using OptionTexts = std::vector<std::pair<std::string, std::string>>;

/// Key and text of every field.
OptionTexts TextsOf(const OptionFields& fields);

/// An option that is not at its usual value.
struct OptionChange {
  std::string key, value, usual;

  bool operator==(const OptionChange&) const = default;
};

/// Those of `texts` that differ from what `usual` holds, in their order; keys that `usual` does not have are left out.
std::vector<OptionChange> ChangesFrom(const OptionFields& usual, const OptionTexts& texts);

/// Joins lists of fields.
OptionFields Joined(std::vector<OptionFields> lists);

}  // namespace gaitwright
