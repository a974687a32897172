// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace gaitwright {

/// A share and its confidence interval.
struct ShareInterval {
  double share = 0.0, low = 0.0, high = 1.0;

  double width() const { return high - low; }
  bool operator==(const ShareInterval&) const = default;
};

/// The share k / n with its 95 % score interval, z = 1.959964:
///   (p + z^2/2n -+ z sqrt(p (1 - p)/n + z^2/4n^2)) / (1 + z^2/n).
/// With n = 0 the interval is from 0 to 1. E. B. Wilson, J. Am. Stat. Assoc. 22(158), 1927,
/// doi:10.1080/01621459.1927.10502953.
/// @throws InvalidArgument unless 0 <= k <= n.
ShareInterval WilsonInterval(int k, int n);

}  // namespace gaitwright
