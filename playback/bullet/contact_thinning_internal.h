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

/// Selects the points that keep a rigid sole out of the ground. The other points lie between selected points whose gap
/// is not larger than theirs by more than 0.01 mm.
/// @return by point.
std::vector<bool> HoldingPoints(const std::vector<Gap>& points);

/// Removes contact points that cannot matter from soles with spheres all over. Inner spheres count only over height
/// fields, and only if they can reach the ground within the step and carry load. Without thinning, a sole at rest on
/// level ground has a hundred contacts.
class ContactThinning {
 public:
  void Thin(btPersistentManifold** manifolds, int num_manifolds, double step_s);

  /// User index of the shape of a sphere at a corner of a sole or inside its outline; other shapes have no such index.
  enum Role { kCorner = 1, kInner = 2 };

 private:
  struct Point {
    btPersistentManifold* manifold;
    int index;
  };
  bool IsNear(const btCollisionObject& link, const btManifoldPoint& point, const btVector3& p_W, double step_s);
  double SpeedAt(const btCollisionObject& link, const btVector3& p_W);
  void ThinLink();

  const btMultiBody* body_ = nullptr;  // body of the velocities below
  std::vector<btVector3> spin_, velocity_;
  const btCollisionObject* link_ = nullptr;  // link of the points below
  std::vector<Point> points_;
  std::vector<Gap> gaps_;
};

}  // namespace gaitwright::bullet
