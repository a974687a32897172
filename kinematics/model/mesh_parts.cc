// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/mesh_parts.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "kinematics/base/text.h"
#include "kinematics/spatial/convex_hull.h"

namespace gaitwright {
namespace {

/// Corners projected on their best-fit plane (Newell), counter-clockwise.
std::vector<Vector2> Flat(const std::vector<int>& corners, const Mesh& mesh) {
  const auto at = [&](std::size_t i) -> const Vector3& {
    return mesh.vertices[static_cast<std::size_t>(corners[i % corners.size()])];
  };
  Vector3 normal = Vector3::Zero();
  for (std::size_t i = 0; i < corners.size(); ++i) normal += (at(i) - at(0)).cross(at(i + 1) - at(0));
  const Vector3 z = normal.norm() > 0.0 ? Vector3(normal.normalized()) : Vector3::UnitZ();
  const Vector3 x = z.unitOrthogonal(), y = z.cross(x);
  std::vector<Vector2> flat;
  for (std::size_t i = 0; i < corners.size(); ++i) flat.emplace_back(x.dot(at(i) - at(0)), y.dot(at(i) - at(0)));
  return flat;
}

bool IsInside(const Vector2& p, const Vector2& a, const Vector2& b, const Vector2& c) {
  return Cross(b - a, p - a) >= 0.0 && Cross(c - b, p - b) >= 0.0 && Cross(a - c, p - c) >= 0.0;
}

/// Whether corner `i` of the remaining corners can be cut off.
bool IsEar(const std::vector<Vector2>& flat, const std::vector<std::size_t>& left, std::size_t i) {
  const std::size_t n = left.size(), before = left[(i + n - 1) % n], after = left[(i + 1) % n];
  const Vector2 &a = flat[before], &b = flat[left[i]], &c = flat[after];
  if (Cross(b - a, c - b) <= 0.0) return false;
  for (const std::size_t k : left) {
    if (k == before || k == left[i] || k == after || flat[k] == a || flat[k] == b || flat[k] == c) continue;
    if (IsInside(flat[k], a, b, c)) return false;
  }
  return true;
}

}  // namespace

void AddFace(const std::vector<int>& corners, Mesh& mesh) {
  const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
    mesh.triangles.emplace_back(corners[a], corners[b], corners[c]);
  };
  if (corners.size() < 3 || corners.size() > kMostFaceCorners) {
    throw InvalidArgument(
        fmt::format("a face has {} corners; three to {} are accepted", corners.size(), kMostFaceCorners));
  }
  if (corners.size() == 3) return add(0, 1, 2);
  const std::vector<Vector2> flat = Flat(corners, mesh);
  std::vector<std::size_t> left;
  for (std::size_t i = 0; i < corners.size(); ++i) left.push_back(i);
  while (left.size() > 3) {
    std::size_t ear = 0;
    while (ear < left.size() && !IsEar(flat, left, ear)) ++ear;
    if (ear == left.size()) ear = 0;  // no ear, because the face crosses itself or has no area: take any corner
    const std::size_t n = left.size();
    add(left[(ear + n - 1) % n], left[ear], left[(ear + 1) % n]);
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  add(left[0], left[1], left[2]);
}

void CheckMeshSize(std::size_t points, std::size_t triangles) {
  if (points > kMostMeshPoints || triangles > kMostMeshTriangles) {
    throw InvalidArgument(
        fmt::format("it has more than {0} points or {1} triangles; at most {0} points and {1} triangles are read",
                    kMostMeshPoints, kMostMeshTriangles));
  }
}

double MeshNumber(const std::string& word, const std::string& what) {
  double value = 0.0;
  const char* begin = word.data() + (word.starts_with('+') ? 1 : 0);
  const char* end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(begin, end, value);
  if (error != std::errc{} || stop != end || !std::isfinite(value))
    throw InvalidArgument(fmt::format("{} is '{}', which is not a finite number", what, Shortened(word)));
  constexpr double kMost = 1e12;
  if (std::abs(value) > kMost)
    throw InvalidArgument(fmt::format("{} is {}; its magnitude may be at most {}", what, value, kMost));
  return value;
}

}  // namespace gaitwright
