// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/model/mesh_file.h"

namespace gaitwright {

/// A convex plane piece that faces up, and its triangles.
struct FlatPiece {
  std::vector<Vector3> corners;  ///< counter-clockwise from above [m]
  std::vector<int> triangles;    ///< indices into Mesh::triangles
};

/// The triangles of a mesh that face up and are at most `steepest_rad` from level, as convex pieces. Connected
/// triangles in one plane (to 1 mm and 0.5 degrees) are one piece if their union is convex. Otherwise neighbours are
/// joined as long as they stay convex. Corners nearer than 0.01 mm are merged. The method is greedy, so the number of
/// pieces may not be minimal; Hertel and Mehlhorn, FCT 1983, bound it by four times the minimum.
/// @param mesh  in metres, z up.
std::vector<FlatPiece> FlatPieces(const Mesh& mesh, double steepest_rad);

}  // namespace gaitwright
