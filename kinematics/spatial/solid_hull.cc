// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/spatial/solid_hull.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

namespace gaitwright {
namespace {

constexpr double kRoundingShare = 1e-10;  // share of the extent of all points; a nearer point is on a face

/// A triangle of the hull and its plane: the hull is where normal . p <= offset.
struct HullFace {
  std::array<int, 3> corners{};
  Vector3 normal = Vector3::Zero();  ///< unit; zero for a triangle without area
  double offset = 0.0;
};

/// The hull of some of the points; points are added one by one.
class GrowingHull {
 public:
  GrowingHull(const std::vector<Vector3>& points, double rounding) : points_(points), rounding_(rounding) {}

  /// @return false if the four points have no volume.
  bool Begin(const std::array<int, 4>& t) {
    const double volume = (At(t[1]) - At(t[0])).cross(At(t[2]) - At(t[0])).dot(At(t[3]) - At(t[0]));
    const int b = volume < 0.0 ? t[1] : t[2], c = volume < 0.0 ? t[2] : t[1];
    for (const auto& corners : {std::array{t[0], b, c}, {t[0], c, t[3]}, {c, b, t[3]}, {b, t[0], t[3]}}) Add(corners);
    return volume != 0.0;
  }

  /// Adds a point: replaces the faces that are visible from it by triangles from their rim to the point.
  void Take(int point) {
    std::set<std::pair<int, int>> edges;
    const auto hidden = std::partition(faces_.begin(), faces_.end(), [&](const HullFace& face) {
      return face.normal.dot(At(point)) - face.offset <= rounding_;
    });
    for (auto face = hidden; face != faces_.end(); ++face) {
      for (std::size_t i = 0; i < 3; ++i) edges.emplace(face->corners[i], face->corners[(i + 1) % 3]);
    }
    faces_.erase(hidden, faces_.end());
    for (const auto& [from, to] : edges) {
      if (!edges.contains({to, from})) Add({from, to, point});
    }
  }

  std::vector<Eigen::Vector3i> Triangles() const {
    std::vector<Eigen::Vector3i> triangles;
    for (const HullFace& face : faces_) triangles.emplace_back(face.corners.data());
    return triangles;
  }

 private:
  const Vector3& At(int point) const { return points_[static_cast<std::size_t>(point)]; }

  void Add(const std::array<int, 3>& corners) {
    HullFace face{corners, (At(corners[1]) - At(corners[0])).cross(At(corners[2]) - At(corners[0])), 0.0};
    const double twice_area = face.normal.norm();
    face.normal = twice_area > 0.0 ? Vector3(face.normal / twice_area) : Vector3(Vector3::Zero());
    face.offset = face.normal.dot(At(corners[0]));
    faces_.push_back(face);
  }

  const std::vector<Vector3>& points_;
  double rounding_;
  std::vector<HullFace> faces_;
};

/// The point with the largest value, and the value.
template <class Value>
std::pair<int, double> Farthest(const std::vector<Vector3>& points, Value value) {
  std::pair<int, double> farthest{0, value(points[0])};
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double here = value(points[i]);
    if (here > farthest.second) farthest = {static_cast<int>(i), here};
  }
  return farthest;
}

}  // namespace

std::vector<Eigen::Vector3i> HullTriangles(const std::vector<Vector3>& points) {
  if (points.size() < 4) return {};
  Eigen::AlignedBox3d box;
  for (const Vector3& p : points) box.extend(p);
  const double rounding = kRoundingShare * box.diagonal().norm();
  // Start with a tetrahedron that is large and quickly found.
  const auto at = [&](int i) -> const Vector3& { return points[static_cast<std::size_t>(i)]; };
  const int a = Farthest(points, [&](const Vector3& p) { return -p.x(); }).first;
  const auto [b, length] = Farthest(points, [&](const Vector3& p) { return (p - at(a)).norm(); });
  if (!(length > rounding)) return {};
  const Vector3 along = (at(b) - at(a)) / length;
  const auto [c, width] = Farthest(points, [&](const Vector3& p) { return along.cross(p - at(a)).norm(); });
  if (!(width > rounding)) return {};
  const Vector3 normal = along.cross(at(c) - at(a)).normalized();
  const auto [d, height] = Farthest(points, [&](const Vector3& p) { return std::abs(normal.dot(p - at(a))); });
  if (!(height > rounding)) return {};
  GrowingHull hull(points, rounding);
  if (!hull.Begin({a, b, c, d})) return {};
  for (int i = 0; i < static_cast<int>(points.size()); ++i) hull.Take(i);
  return hull.Triangles();
}

}  // namespace gaitwright
