// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/model/mesh_file.h"

namespace gaitwright {

/// A convex piece of plane that faces up, and the triangles that it is made of.
struct FlatPiece {
  std::vector<Vector3> corners;  ///< counter-clockwise from above [m]
  std::vector<int> triangles;    ///< indices into Mesh::triangles
};

/// The triangles of a mesh that face up at most `steepest_rad` from level, as convex pieces: connected triangles in one
/// plane (to 1 mm and 0.5 degrees) make one piece where their union is convex, else such pieces as come from joining
/// neighbours as long as they stay convex. Corners that are nearer than 0.01 mm are one.
/// Greedy, so not the fewest pieces; Hertel and Mehlhorn, FCT 1983, bound it by four times as many.
/// @param mesh  in metres, z up.
std::vector<FlatPiece> FlatPieces(const Mesh& mesh, double steepest_rad);

}  // namespace gaitwright
