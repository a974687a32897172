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
  bool advanced = false;                  ///< only in the list of all options; see WithBasics
};

using OptionFields = std::vector<OptionField>;

/// "'a', 'b', 'c'", for messages with lists of names.
std::string QuotedList(const std::vector<std::string>& names);

/// Sets the field `key` from a text. @throws InvalidArgument for an unknown key (with the nearest one), and for a value
/// that cannot be read, is not finite or is outside the range.
void SetOption(OptionFields& fields, const std::string& key, const std::string& text);

/// The current value of a field as a text that SetOption reads back exactly.
std::string OptionText(const OptionField& field);

/// @throws InvalidArgument that names the first field whose value is not finite or outside its range.
void CheckOptions(const OptionFields& fields);

/// `fields` with `prefix` + '.' before every key, so that several structs share one namespace.
OptionFields Prefixed(const std::string& prefix, OptionFields fields);

/// `fields`, all marked as advanced, except those with a key in `basics`, which users need first.
/// @throws InvalidArgument if no field has one of these keys.
OptionFields WithBasics(const std::vector<std::string>& basics, OptionFields fields);

/// Options as pairs of key and text.
using OptionTexts = std::vector<std::pair<std::string, std::string>>;

/// Key and text of every field.
OptionTexts TextsOf(const OptionFields& fields);

/// An option with a value other than its usual one.
struct OptionChange {
  std::string key, value, usual;

  bool operator==(const OptionChange&) const = default;
};

/// The options of `texts` whose values differ from those of `usual`, in the same order. Keys that are not in `usual`
/// are left out.
std::vector<OptionChange> ChangesFrom(const OptionFields& usual, const OptionTexts& texts);

/// Joins lists of fields.
OptionFields Joined(std::vector<OptionFields> lists);

}  // namespace gaitwright
