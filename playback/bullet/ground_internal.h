// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <btBulletDynamicsCommon.h>

#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "planning/plan/terrain.h"
#include "playback/engine/bumps.h"

namespace gaitwright::bullet {

/// The terrain as static bodies: infinite planes, convex blocks under bounded patches, height fields and obstacles.
/// With bumps: obstacles and one height field of the whole ground.
class Ground {
 public:
  /// @param bumps  their start is also the point about which the slope turns the ground.
  Ground(const Terrain& terrain, const WorldOptions& options, const Bumps& bumps);

  void AddTo(btCollisionWorld& world);
  /// Name of a body of the ground, see SolidNames; empty for other bodies.
  std::string NameOf(const btCollisionObject* object) const;
  /// True when edges can touch too, so that soles need plates as well as spheres.
  bool has_edges() const { return has_edges_; }
  /// Distance between points of the finest height field; zero without a height field [m].
  double finest_m() const { return finest_m_; }

 private:
  void AddObject(std::unique_ptr<btCollisionShape> shape, const Pose& X_WS, double friction);
  void AddPatch(const TerrainPatch& patch, double friction);
  void AddHeightField(HeightField field, double friction);
  void AddObstacle(const Obstacle& obstacle, double friction);

  Pose X_tilt_;
  bool has_edges_ = false;
  double finest_m_ = 0.0;
  std::deque<std::vector<double>> heights_;  ///< by field; the addresses stay valid
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btCollisionObject>> objects_;
  std::vector<std::string> names_;  ///< by object
};

}  // namespace gaitwright::bullet
