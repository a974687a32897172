// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <btBulletDynamicsCommon.h>

#include <memory>
#include <vector>

#include "planning/plan/terrain.h"
#include "playback/bullet/world_options.h"

namespace gaitwright::bullet {

/// Bumps: value noise on a square grid of half a wavelength, blended by 6u^5 - 15u^4 + 10u^3, uniform in
/// [-amplitude, amplitude], times a rise from zero at `free_radius` from `start` to one half a wavelength further.
/// Perlin, ACM SIGGRAPH 2002, doi:10.1145/566654.566636, for the blend.
struct Bumps {
  Vector2 start = Vector2::Zero();
  double amplitude = 0.0, wavelength = 0.4, free_radius = 0.0;
  std::uint64_t seed = 1;

  double HeightAt(const Vector2& p_W) const;
};

/// The terrain as static bodies: planes without end, convex blocks under bounded patches, or a height field of it all
/// when there are bumps.
class Ground {
 public:
  /// @param start  where the slope turns and where bumps are zero.
  Ground(const Terrain& terrain, const WorldOptions& options, const Vector2& start);

  void AddTo(btCollisionWorld& world);
  /// True when contact happens on edges too, so that soles must be plates too.
  bool has_edges() const { return has_edges_; }

 private:
  void AddObject(std::unique_ptr<btCollisionShape> shape, const Pose& X_WS, double friction);
  void AddPatch(const TerrainPatch& patch, double friction);
  void AddHeightField(const Terrain& terrain, const WorldOptions& options, const Bumps& bumps);

  Pose X_tilt_;
  bool has_edges_ = false;
  std::vector<double> heights_;
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btCollisionObject>> objects_;
};

}  // namespace gaitwright::bullet
