// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace gaitwright {

/// Which way a metric gets better.
enum class Better { kLower, kHigher, kNeither };

/// How a value is compared with its limit.
enum class Bound { kNone, kAtMost, kAtLeast, kAbove };

/// A metric by which a playback is judged. Always true: `pass` is false only where a gate is applied, a value exists
/// and it breaks the limit.
struct Metric {
  std::string key;                ///< ends in its SI unit
  std::string unit;               ///< "1" for shares and counts
  std::optional<double> value;    ///< nothing where the motion has no such thing
  std::optional<double> planned;  ///< value of the plan, by the same code
  std::optional<double> limit;    ///< of the gate, if there is one
  Bound bound = Bound::kNone;
  bool applied = false;  ///< the gate is
  bool pass = true;
  std::string not_applied;     ///< why a value or a gate is missing
  std::optional<double> at_s;  ///< when it was worst

  bool operator==(const Metric&) const = default;
};

}  // namespace gaitwright
