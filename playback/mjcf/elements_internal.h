// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "kinematics/model/robot_model.h"
#include "kinematics/spatial/pose.h"
#include "playback/engine/world_options.h"

// MJCF elements that robot and ground share.
namespace gaitwright::mujoco {

/// A number as text that reads back exactly.
inline std::string Number(double value) { return fmt::format("{:.17g}", value); }

/// Numbers separated by spaces.
template <class Vector>
std::string Numbers(const Vector& values) {
  std::string text;
  for (Eigen::Index i = 0; i < values.size(); ++i) text += (i > 0 ? " " : "") + Number(values[i]);
  return text;
}

/// Attributes of a pose.
std::string PlaceOf(const Pose& X);

/// Attributes of a geom's shape. A mesh is given by its points; MuJoCo uses their convex hull.
/// @param mesh  name of the asset for a mesh, escaped as XML. @param assets  the text to which the asset is appended.
std::string ShapeText(const Shape& shape, const std::string& mesh, std::string& assets);

/// ShapeText of a mesh with these points. MuJoCo moves a mesh to its own centre and principal axes and compensates this
/// in the geom's pose.
std::string MeshText(const std::vector<Vector3>& vertices, const std::string& mesh, std::string& assets);

/// Attributes of a geom's contact solution, except friction.
std::string ContactAttributes(const WorldOptions& options);

}  // namespace gaitwright::mujoco
