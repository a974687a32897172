// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace gaitwright::engine {

inline constexpr double kMostOfState = 1e6;  // beyond it numbers are no physics any more [m], [rad], [m/s], [rad/s]
inline constexpr double kMostForce = 1e12;   // likewise [N], [N m]

/// Whether all numbers are finite and not beyond a bound.
template <class Numbers>
bool Within(const Numbers& numbers, double most) {
  return (numbers.array().abs() <= most).all();  // which what is no number is not
}

}  // namespace gaitwright::engine
