// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// Rows of numbers as stored in a scene: the number of columns, and base64 of their little-endian values.
nlohmann::ordered_json Packed(int columns, const std::vector<float>& values);
nlohmann::ordered_json Packed(int columns, const std::vector<std::uint32_t>& values);
nlohmann::ordered_json Packed(int columns, const std::vector<std::uint8_t>& values);

/// Points as rows of x, y, z.
nlohmann::ordered_json PackedPoints(const std::vector<Vector3>& points);

/// x, y, z, then the quaternion x, y, z, w.
nlohmann::ordered_json PoseJson(const Pose& pose);

/// A finite number, or null.
nlohmann::ordered_json FiniteOrNull(double value);

}  // namespace gaitwright
