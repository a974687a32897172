// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace gaitwright {

/// What a value may be.
struct Bounds {
  double low = 0.0, high = 0.0;
};

/// The numbers z that make
///   sum (z_k - wanted_k)^2 + stiff^4 sum (z_{k-1} - 2 z_k + z_{k+1})^2 + firm sum (z_k beyond its bounds)^2
/// least, level beyond both ends: near to what is wanted, in their bounds, and without sharp bends, which are spread
/// over about `stiff` numbers. Bounds that ask for sharper ones are not kept; those that contradict themselves become
/// their middle. Exact: the bounds that hold are found one set after another.
/// @throws InvalidArgument unless there are three numbers or more, and as many bounds.
std::vector<double> SmoothWithin(const std::vector<double>& wanted, const std::vector<Bounds>& bounds, double stiff,
                                 double firm);

}  // namespace gaitwright
