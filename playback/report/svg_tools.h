// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/base/text.h"
#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// Round numbers from `lowest` to `highest`, in steps of 1, 2 or 5 times a power of ten, about `count` of them and at
/// least two. Empty unless both are finite and lowest < highest by more than rounding.
std::vector<double> RoundTicks(double lowest, double highest, int count);

/// A subset of the points whose line differs by at most `tolerance` from the original (Douglas and Peucker,
/// Cartographica 10(2) 1973). The tolerance is doubled until at most `most` points remain.
std::vector<Vector2> Simplified(const std::vector<Vector2>& points, double tolerance, std::size_t most);

/// Elements of SVG; coordinates in pixels. An empty text gives no element.
std::string SvgText(double x, double y, const std::string& css, const std::string& words);
std::string SvgSegment(const Vector2& a, const Vector2& b, const std::string& css);

}  // namespace gaitwright
