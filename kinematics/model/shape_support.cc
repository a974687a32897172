// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/shape_support.h"

#include <algorithm>
#include <cmath>

namespace gaitwright {

Vector3 SupportPoint(const Shape& shape, const Vector3& direction_S) {
  switch (shape.type) {
    case ShapeType::kBox:
      return 0.5 * shape.size.cwiseProduct(direction_S.cwiseSign());
    case ShapeType::kSphere:
      return shape.size.x() * direction_S.normalized();
    case ShapeType::kCapsule:
    case ShapeType::kCylinder: {
      Vector3 p_S(0.0, 0.0, std::copysign(0.5 * shape.size.y(), direction_S.z()));
      if (shape.type == ShapeType::kCapsule) {
        p_S += shape.size.x() * direction_S.normalized();
      } else if (direction_S.head<2>().norm() > 1e-12) {
        p_S.head<2>() = shape.size.x() * direction_S.head<2>().normalized();
      }
      return p_S;
    }
    case ShapeType::kMesh:
      break;
  }
  if (shape.vertices.empty()) return Vector3::Zero();
  return *std::max_element(shape.vertices.begin(), shape.vertices.end(),
                           [&](const Vector3& a, const Vector3& b) { return a.dot(direction_S) < b.dot(direction_S); });
}

std::vector<Vector3> BoxCorners(const Vector3& size_m) {
  std::vector<Vector3> corners;
  for (int i = 0; i < 8; ++i) {
    const Vector3 sign(i % 2 == 0 ? -0.5 : 0.5, i / 2 % 2 == 0 ? -0.5 : 0.5, i / 4 == 0 ? -0.5 : 0.5);
    corners.emplace_back(sign.cwiseProduct(size_m));
  }
  return corners;
}

double BoundingRadius(const Shape& shape) {
  if (shape.type == ShapeType::kBox) return 0.5 * shape.size.norm();
  if (shape.type == ShapeType::kSphere) return shape.size.x();
  if (shape.type == ShapeType::kMesh) {
    double radius = 0.0;
    for (const Vector3& v : shape.vertices) radius = std::max(radius, v.norm());
    return radius;
  }
  if (shape.type == ShapeType::kCapsule) return shape.size.x() + 0.5 * shape.size.y();
  return std::hypot(shape.size.x(), 0.5 * shape.size.y());
}

}  // namespace gaitwright
