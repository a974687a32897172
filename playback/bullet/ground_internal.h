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

/// The terrain as static bodies: planes without end, convex blocks under bounded patches, height fields, obstacles; or
/// obstacles and one height field of all ground when there are bumps.
class Ground {
 public:
  /// @param bumps  begin where the slope turns.
  Ground(const Terrain& terrain, const WorldOptions& options, const Bumps& bumps);

  void AddTo(btCollisionWorld& world);
  /// Name of one of its bodies, see SolidNames; empty for others.
  std::string NameOf(const btCollisionObject* object) const;
  /// True when contact happens on edges too, so that soles must be plates too.
  bool has_edges() const { return has_edges_; }
  /// Between the points of the finest height field; zero where there is none [m].
  double finest_m() const { return finest_m_; }

 private:
  void AddObject(std::unique_ptr<btCollisionShape> shape, const Pose& X_WS, double friction);
  void AddPatch(const TerrainPatch& patch, double friction);
  void AddHeightField(HeightField field, double friction);
  void AddObstacle(const Obstacle& obstacle, double friction);

  Pose X_tilt_;
  bool has_edges_ = false;
  double finest_m_ = 0.0;
  std::deque<std::vector<double>> heights_;  ///< by field; they stay where they are
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btCollisionObject>> objects_;
  std::vector<std::string> names_;  ///< by object
};

}  // namespace gaitwright::bullet
