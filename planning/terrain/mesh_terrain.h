// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/base/options.h"
#include "kinematics/base/result.h"
#include "kinematics/model/mesh_file.h"
#include "planning/plan/terrain.h"

namespace gaitwright {

/// How a mesh becomes ground.
struct MeshTerrainOptions {
  double scale = 1.0;
  double least_m = 0.04;
  double steepest_deg = 45.0;
  double resolution_m = 0.02;
  double x_m = 0.0, y_m = 0.0, z_m = 0.0;
  double friction = 0.8;

  OptionFields Fields();
};

/// Ground from the faces of a mesh (z up) that look up: its flat convex pieces that a foot has room on are patches, and
/// over the rest that looks up lies a height field of the mesh's highest points, which slopes over one cell where the
/// mesh has a step. What hangs over the ground is lost.
/// Failure kBadInput: no face that looks up, a corner beyond kFarthest or kHighest, a height field of more than
/// kMostNodes, options out of range. @param name  of the file, for messages.
Result<Terrain> TerrainFromMesh(const Mesh& mesh, const MeshTerrainOptions& options, const std::string& name);

}  // namespace gaitwright
