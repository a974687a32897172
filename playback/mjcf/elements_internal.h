// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "kinematics/model/robot_model.h"
#include "kinematics/spatial/pose.h"
#include "playback/engine/world_options.h"

// Pieces of MJCF that robot and ground have in common.
namespace gaitwright::mujoco {

/// A number that reads back exactly.
inline std::string Number(double value) { return fmt::format("{:.17g}", value); }

/// Numbers with spaces between.
template <class Vector>
std::string Numbers(const Vector& values) {
  std::string text;
  for (Eigen::Index i = 0; i < values.size(); ++i) text += (i > 0 ? " " : "") + Number(values[i]);
  return text;
}

/// The attributes of a pose.
std::string PlaceOf(const Pose& X);

/// The attributes of a geom's shape. A mesh is given by its points, of which MuJoCo takes the convex hull.
/// @param mesh  name of the asset that a mesh becomes, escaped as XML. @param assets  where that is added.
std::string ShapeText(const Shape& shape, const std::string& mesh, std::string& assets);

/// ShapeText of a mesh of these points. MuJoCo moves a mesh to its own centre and principal axes and makes up for that
/// in the geom's pose.
std::string MeshText(const std::vector<Vector3>& vertices, const std::string& mesh, std::string& assets);

/// The attributes that say how contacts of a geom are solved, but for friction.
std::string ContactAttributes(const WorldOptions& options);

}  // namespace gaitwright::mujoco
