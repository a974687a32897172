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

/// Settings for writing a ground.
struct GroundStyle {
  Pose X_tilt = Pose::Identity();         ///< pose change of the whole ground
  double friction = 0.0;                  ///< of the whole ground; 0: each part has its own
  std::vector<std::string> names;         ///< of obstacles, patches and height fields in this order, all different
  std::string attributes;                 ///< of each geom, in addition to name, shape, pose and friction
  std::vector<std::string> height_files;  ///< of each height field; empty where heights stay in memory
};

/// The ground of a MuJoCo file: its asset and worldbody elements, and the heights that are not in them. A geom and its
/// mesh or height field have the same name.
struct GroundText {
  std::string assets, geoms;
  std::vector<FieldHeights> fields;
  bool has_edges = false;  ///< whether any patch is bounded
  double finest_m = 0.0;   ///< resolution of the finest height field; 0 without one
};

/// Writes a ground without a robot. @throws std::out_of_range if there are fewer names or files than parts.
GroundText WriteGround(const Terrain& terrain, const GroundStyle& style);

}  // namespace gaitwright::mujoco
