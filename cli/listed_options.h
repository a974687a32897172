// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <exception>
#include <string>
#include <utility>

#include "kinematics/base/options.h"

namespace gaitwright::cli {

/// Thrown by --list-options: the options to print.
class ListedOptions : public std::exception {
 public:
  ListedOptions(OptionFields fields, bool as_json) : fields_(std::move(fields)), as_json_(as_json) {}

  const OptionFields& fields() const { return fields_; }
  bool as_json() const { return as_json_; }

 private:
  OptionFields fields_;
  bool as_json_;
};

/// The basic fields, then the advanced ones if `all`; otherwise the order is kept.
OptionFields BasicsFirst(OptionFields fields, bool all);

/// The accepted values of the field: "0 to 1", "true, false", its words, or "text".
std::string AcceptedOf(const OptionField& field);

/// Prints the fields with their units, ranges and defaults.
void PrintOptions(const OptionFields& fields, bool as_json);

}  // namespace gaitwright::cli
