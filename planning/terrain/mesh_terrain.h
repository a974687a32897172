// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/base/options.h"
#include "kinematics/base/result.h"
#include "kinematics/model/mesh_file.h"
#include "planning/plan/terrain.h"

namespace gaitwright {

/// Conversion of a mesh to ground.
struct MeshTerrainOptions {
  double scale = 1.0;
  double least_m = 0.04;
  double steepest_deg = 45.0;
  double resolution_m = 0.02;
  double x_m = 0.0, y_m = 0.0, z_m = 0.0;
  double friction = 0.8;

  OptionFields Fields();
};

/// Ground from the faces of a mesh (z up) that face up. Flat convex pieces that are large enough for a foot become
/// patches. All other upward faces become a height field of the mesh's highest points; at a step of the mesh it slopes
/// over one cell. Geometry below an overhang is lost.
/// Failure kBadInput: no face that points up, a corner beyond kFarthest or kHighest, a height field of more than
/// kMostNodes points, options out of range.
/// @param name  name of the file, for messages.
Result<Terrain> TerrainFromMesh(const Mesh& mesh, const MeshTerrainOptions& options, const std::string& name);

}  // namespace gaitwright
