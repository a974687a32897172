// SPDX-License-Identifier: BSD-3-Clause
#include <bit>
#include <cmath>

#include "kinematics/base/base64_internal.h"
#include "playback/viewer/packed_columns_internal.h"

namespace gaitwright {
namespace {

using Json = nlohmann::ordered_json;

static_assert(std::endian::native == std::endian::little, "columns are packed in memory order");

template <class Number>
std::string Bytes(const std::vector<Number>& values) {
  return Base64({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Number)});
}

}  // namespace

Json Packed(int columns, const std::vector<float>& values) { return {{"columns", columns}, {"f32", Bytes(values)}}; }

Json Packed(int columns, const std::vector<std::uint32_t>& values) {
  return {{"columns", columns}, {"u32", Bytes(values)}};
}

Json Packed(int columns, const std::vector<std::uint8_t>& values) {
  return {{"columns", columns}, {"u8", Bytes(values)}};
}

Json PackedPoints(const std::vector<Vector3>& points) {
  std::vector<float> values;
  values.reserve(3 * points.size());
  for (const Vector3& p : points)
    for (Eigen::Index i = 0; i < 3; ++i) values.push_back(static_cast<float>(p[i]));
  return Packed(3, values);
}

Json PoseJson(const Pose& pose) {
  const Quaternion R(pose.linear());
  const Vector3 p = pose.translation();
  return Json::array({p.x(), p.y(), p.z(), R.x(), R.y(), R.z(), R.w()});
}

Json FiniteOrNull(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

}  // namespace gaitwright
