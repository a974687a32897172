// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <limits>

#include "playback/bullet/robot_body_internal.h"

namespace gaitwright::bullet {
namespace {

constexpr double kPlateThickness = 0.01;  // [m]
constexpr double kPlateMargin = 0.0005;   // collision margin, inside the plate [m]
constexpr double kSameSurface = 0.002;    // a shape this near to the sole's plane is the sole [m]

Vector3 SupportPoint(const Shape& shape, const Vector3& d_S) {
  switch (shape.type) {
    case ShapeType::kBox:
      return 0.5 * shape.size.cwiseProduct(d_S.cwiseSign());
    case ShapeType::kSphere:
      return shape.size.x() * d_S.normalized();
    case ShapeType::kCylinder:
    case ShapeType::kCapsule: {
      const double half = 0.5 * shape.size.y() * (d_S.z() < 0.0 ? -1.0 : 1.0);
      if (shape.type == ShapeType::kCapsule) return Vector3(0.0, 0.0, half) + shape.size.x() * d_S.normalized();
      const Vector2 side = d_S.head<2>();
      const Vector2 rim = side.norm() > 1e-12 ? Vector2(shape.size.x() * side.normalized()) : Vector2::Zero();
      return {rim.x(), rim.y(), half};
    }
    case ShapeType::kMesh:
      break;
  }
  const auto best = std::max_element(shape.vertices.begin(), shape.vertices.end(),
                                     [&](const Vector3& a, const Vector3& b) { return a.dot(d_S) < b.dot(d_S); });
  return best == shape.vertices.end() ? Vector3(Vector3::Zero()) : *best;
}

std::unique_ptr<btConvexHullShape> Hull(const std::vector<Vector3>& points) {
  auto hull = std::make_unique<btConvexHullShape>();
  for (const Vector3& p : points) hull->addPoint(ToBullet(p), false);
  hull->recalcLocalAabb();
  return hull;
}

}  // namespace

std::unique_ptr<btCollisionShape> MakeShape(const Shape& shape) {
  switch (shape.type) {
    case ShapeType::kBox:
      return std::make_unique<btBoxShape>(ToBullet(Vector3(0.5 * shape.size)));
    case ShapeType::kSphere:
      return std::make_unique<btSphereShape>(shape.size.x());
    case ShapeType::kCylinder:
      return std::make_unique<btCylinderShapeZ>(btVector3(shape.size.x(), shape.size.x(), 0.5 * shape.size.y()));
    case ShapeType::kCapsule:
      return std::make_unique<btCapsuleShapeZ>(shape.size.x(), shape.size.y());
    case ShapeType::kMesh:
      break;
  }
  if (shape.vertices.empty()) return nullptr;
  auto hull = Hull(shape.vertices);
  hull->setMargin(0.0);
  return hull;
}

std::unique_ptr<btCollisionShape> MakeSolePlate(const std::vector<Vector2>& sole_F) {
  Vector2 middle = Vector2::Zero();
  for (const Vector2& corner : sole_F) middle += corner / static_cast<double>(sole_F.size());
  std::vector<Vector3> points;
  for (const Vector2& corner : sole_F) {
    // The margin grows the hull on all sides, so it starts that much smaller.
    const Vector2 inward = (corner - middle).cwiseSign() * kPlateMargin;
    const Vector2 c = corner - inward;
    points.emplace_back(c.x(), c.y(), kPlateMargin);
    points.emplace_back(c.x(), c.y(), kPlateThickness - kPlateMargin);
  }
  auto hull = Hull(points);
  hull->setMargin(kPlateMargin);
  return hull;
}

bool IsShapeOfFoot(const Foot& foot, const Shape& shape) {
  if (shape.body != foot.body) return false;
  if (shape.link == foot.link) return true;
  const Pose X_FS = foot.X_BF.inverse() * shape.X_BS;
  const Vector3 down_S = X_FS.linear().transpose() * -Vector3::UnitZ();
  const double lowest = (X_FS * SupportPoint(shape, down_S)).z();
  return lowest < kSameSurface - foot.radius;
}

}  // namespace gaitwright::bullet
