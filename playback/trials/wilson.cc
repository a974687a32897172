// SPDX-License-Identifier: BSD-3-Clause
#include "playback/trials/wilson.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kinematics/base/result.h"

namespace gaitwright {

ShareInterval WilsonInterval(int k, int n) {
  if (k < 0 || k > n)
    throw InvalidArgument(fmt::format("{} of {} is not a share; the first number must be from 0 to the second", k, n));
  if (n == 0) return {};
  constexpr double z = 1.959963984540054;
  const double count = n, p = k / count, scale = 1.0 + z * z / count;
  const double middle = p + 0.5 * z * z / count;
  const double half = z * std::sqrt(p * (1.0 - p) / count + 0.25 * z * z / (count * count));
  const double low = k == 0 ? 0.0 : (middle - half) / scale, high = k == n ? 1.0 : (middle + half) / scale;
  return {p, std::clamp(low, 0.0, 1.0), std::clamp(high, 0.0, 1.0)};
}

}  // namespace gaitwright
