// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "planning/plan/terrain.h"

namespace gaitwright::mujoco {

/// A height field of the world: MuJoCo reads its heights from memory or from a file, not from its text.
struct FieldHeights {
  int rows = 0, columns = 0;
  std::vector<float> heights;  ///< row by row, from 0 to 1 of the field's rise
};

/// How a ground is written.
struct GroundStyle {
  Pose X_tilt = Pose::Identity();         ///< turns all of it
  double friction = 0.0;                  ///< of all of it; 0: each part has its own
  std::vector<std::string> names;         ///< of obstacles, patches and height fields in this order, each different
  std::string attributes;                 ///< of each geom, besides name, shape, pose and friction
  std::vector<std::string> height_files;  ///< of each height field; empty where heights stay in memory
};

/// The ground of a file of MuJoCo: the elements of its asset and worldbody, and the heights that these do not hold. A
/// geom and its mesh or height field have the same name.
struct GroundText {
  std::string assets, geoms;
  std::vector<FieldHeights> fields;
  bool has_edges = false;  ///< whether a patch is bounded
  double finest_m = 0.0;   ///< resolution of the finest height field; 0 without one
};

/// Writes a ground without a robot. @throws std::out_of_range for fewer names or files than there are parts.
GroundText WriteGround(const Terrain& terrain, const GroundStyle& style);

}  // namespace gaitwright::mujoco
