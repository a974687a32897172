// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace gaitwright {

/// Bounds of a value.
struct Bounds {
  double low = 0.0, high = 0.0;
};

/// The numbers z that make
///   sum (z_k - wanted_k)^2 + stiff^4 sum (z_{k-1} - 2 z_k + z_{k+1})^2 + firm sum (z_k beyond its bounds)^2 minimal,
/// constant beyond both ends: near the wanted values, within bounds, and without sharp bends, which are spread over
/// about `stiff` numbers. Bounds that need sharper bends are violated; contradictory bounds become their middle. Exact,
/// by an active-set method.
/// @throws InvalidArgument unless there are three numbers or more, and as many bounds.
std::vector<double> SmoothWithin(const std::vector<double>& wanted, const std::vector<Bounds>& bounds, double stiff,
                                 double firm);

}  // namespace gaitwright
