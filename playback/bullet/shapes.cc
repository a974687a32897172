// SPDX-License-Identifier: BSD-3-Clause
#include "playback/bullet/robot_body_internal.h"

namespace gaitwright::bullet {
namespace {

constexpr double kPlateThickness = 0.01;  // [m]
constexpr double kPlateMargin = 0.0005;   // collision margin, inside the plate [m]

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
    // The margin grows the hull on all sides, so the hull starts smaller by the margin.
    const Vector2 inward = (corner - middle).cwiseSign() * kPlateMargin;
    const Vector2 c = corner - inward;
    points.emplace_back(c.x(), c.y(), kPlateMargin);
    points.emplace_back(c.x(), c.y(), kPlateThickness - kPlateMargin);
  }
  auto hull = Hull(points);
  hull->setMargin(kPlateMargin);
  return hull;
}

}  // namespace gaitwright::bullet
