// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/collision/shape_extent.h"

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

Vector3 LowestPoint(const DynamicsScratch& scratch, const Shape& shape) {
  const Pose X_WS = FramePose(scratch, shape.body, shape.X_BS);
  return X_WS * SupportPoint(shape, -X_WS.linear().row(2).transpose());
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

bool IsShapeOfFoot(const Foot& foot, const Shape& shape) {
  constexpr double kSameSurface = 2e-3;  // [m]
  if (shape.link == foot.link) return true;
  if (shape.body != foot.body) return false;
  const Pose X_FS = foot.X_BF.inverse() * shape.X_BS;
  const Vector3 down_S = X_FS.linear().transpose() * -Vector3::UnitZ();
  return (X_FS * SupportPoint(shape, down_S)).z() < kSameSurface - foot.radius;
}

bool IsShapeOfAFoot(const RobotModel& model, const Shape& shape) {
  return std::any_of(model.feet.begin(), model.feet.end(),
                     [&](const Foot& foot) { return IsShapeOfFoot(foot, shape); });
}

}  // namespace gaitwright
