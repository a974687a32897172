// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <vector>

#include "kinematics/collision/fcl_shape_internal.h"

namespace gaitwright {

std::shared_ptr<fcl::CollisionGeometryd> FclGeometry(const Shape& shape) {
  switch (shape.type) {
    case ShapeType::kBox:
      return std::make_shared<fcl::Boxd>(shape.size);
    case ShapeType::kSphere:
      return std::make_shared<fcl::Sphered>(shape.size.x());
    case ShapeType::kCylinder:
      return std::make_shared<fcl::Cylinderd>(shape.size.x(), shape.size.y());
    case ShapeType::kCapsule:
      return std::make_shared<fcl::Capsuled>(shape.size.x(), shape.size.y());
    case ShapeType::kMesh:
      break;
  }
  if (shape.vertices.empty()) return nullptr;
  // Faces are not needed: without them, FCL searches all points for the farthest one.
  return std::make_shared<fcl::Convexd>(std::make_shared<std::vector<Vector3>>(shape.vertices), 0,
                                        std::make_shared<std::vector<int>>());
}

double SignedGap(const fcl::CollisionObjectd& a, const fcl::CollisionObjectd& b) {
  fcl::DistanceResultd distance;
  constexpr double kSolver = 1e-5;  // [m] error of the distance
  const double apart = fcl::distance(&a, &b, fcl::DistanceRequestd(), distance) - kSolver;
  if (apart > 0.0) return apart;
  constexpr std::size_t kMostContacts = 16;
  fcl::CollisionResultd result;
  fcl::collide(&a, &b, fcl::CollisionRequestd(kMostContacts, true), result);
  double depth = 0.0;
  for (std::size_t i = 0; i < result.numContacts(); ++i)
    depth = std::max(depth, result.getContact(i).penetration_depth);
  return result.isCollision() ? -depth : 0.0;
}

}  // namespace gaitwright
