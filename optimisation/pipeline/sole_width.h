// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// Width of a sole along y of F [m]; 0 for a foot without a sole.
inline double SoleWidth(const Foot& foot) {
  const auto [low, high] = std::minmax_element(foot.sole_F.begin(), foot.sole_F.end(),
                                               [](const Vector2& a, const Vector2& b) { return a.y() < b.y(); });
  return foot.sole_F.empty() ? 0.0 : high->y() - low->y();
}

}  // namespace gaitwright
