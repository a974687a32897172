// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace gaitwright::engine {

inline constexpr double kMostOfState = 1e6;  // beyond this bound numbers are not physical [m], [rad], [m/s], [rad/s]
inline constexpr double kMostForce = 1e12;   // beyond this bound forces and moments are not physical [N], [N m]

/// Whether all numbers are finite and within a bound.
template <class Numbers>
bool Within(const Numbers& numbers, double most) {
  return (numbers.array().abs() <= most).all();  // false for NaN
}

}  // namespace gaitwright::engine
