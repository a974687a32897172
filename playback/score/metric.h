// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace gaitwright {

/// Direction in which a metric improves.
enum class Better { kLower, kHigher, kNeither };

/// Comparison of a value with its limit.
enum class Bound { kNone, kAtMost, kAtLeast, kAbove };

/// A metric of a playback. Invariant: `pass` is false only if a gate is applied, a value exists and it violates the
/// limit.
struct Metric {
  std::string key;                ///< ends in its SI unit
  std::string unit;               ///< "1" for shares and counts
  std::optional<double> value;    ///< nothing if the motion has no such value
  std::optional<double> planned;  ///< value of the plan, by the same code
  std::optional<double> limit;    ///< of the gate, if there is one
  Bound bound = Bound::kNone;
  bool applied = false;  ///< whether the gate is applied
  bool pass = true;
  std::string not_applied;     ///< reason for a missing value or gate
  std::optional<double> at_s;  ///< time of the worst value

  bool operator==(const Metric&) const = default;
};

}  // namespace gaitwright
