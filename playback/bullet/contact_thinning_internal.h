// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <BulletDynamics/Featherstone/btMultiBody.h>

#include <vector>

#include "kinematics/spatial/convex_hull.h"

namespace gaitwright::bullet {

/// Point of a rigid sole and its height over the ground.
struct Gap {
  Vector2 place;       ///< [m]
  double gap_m = 0.0;  ///< negative in the ground
};

/// Which points keep a rigid sole out of the ground. The others are between points that are no higher over it, to a
/// hundredth of a millimetre, so that those hold them too.
/// @return by point.
std::vector<bool> HoldingPoints(const std::vector<Gap>& points);

/// Leaves, of the contact points of soles that have spheres all over, those that matter: of inner spheres those over
/// height fields, and there only what can reach the ground within the step and carries. Without it a sole at rest on
/// level ground has a hundred contacts.
class ContactThinning {
 public:
  void Thin(btPersistentManifold** manifolds, int num_manifolds, double step_s);

  /// User index of the shape of a sphere at a sole's corner or inside its outline; others have none.
  enum Role { kCorner = 1, kInner = 2 };

 private:
  struct Point {
    btPersistentManifold* manifold;
    int index;
  };
  bool IsNear(const btCollisionObject& link, const btManifoldPoint& point, const btVector3& p_W, double step_s);
  double SpeedAt(const btCollisionObject& link, const btVector3& p_W);
  void ThinLink();

  const btMultiBody* body_ = nullptr;  // whose velocities are below
  std::vector<btVector3> spin_, velocity_;
  const btCollisionObject* link_ = nullptr;  // whose points are below
  std::vector<Point> points_;
  std::vector<Gap> gaps_;
};

}  // namespace gaitwright::bullet
