// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <variant>

namespace gaitwright {

/// Certainty that a suggestion helps.
enum class Certainty {
  kPlanned,    ///< a plan with it was computed and passes its audit
  kEstimated,  ///< estimated without a whole plan
  kUntried,
};
/// The name in JSON and Python: `planned`, `estimated` or `untried`.
const char* CertaintyName(Certainty certainty);

/// A hint for a refused request.
struct Suggestion {
  /// The flag or option to give, without dashes: `speed`, `gait`, `pipeline.allow_limits`. Empty for advice in words.
  std::string what;
  /// Value to set, in the option's unit; empty if unknown.
  std::variant<std::monostate, double, std::string> value;
  Certainty certainty = Certainty::kUntried;
  std::string text;  ///< text for the user, such as "--speed 0.4" or "another gait"

  /// Advice in words.
  Suggestion(std::string words) : text(std::move(words)) {}  // NOLINT(google-explicit-constructor)
  Suggestion(const char* words) : text(words) {}             // NOLINT(google-explicit-constructor)
  Suggestion(std::string option, std::variant<std::monostate, double, std::string> its_value, Certainty how_sure,
             std::string words)
      : what(std::move(option)), value(std::move(its_value)), certainty(how_sure), text(std::move(words)) {}

  bool operator==(const Suggestion&) const = default;
};

}  // namespace gaitwright
