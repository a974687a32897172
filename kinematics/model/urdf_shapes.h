// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
#include <string>
#include <vector>

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// A URDF in two parts: its tree, as a URDF without geometry, and the geometry. Each shape has its link's name, X_BS is
/// its pose in that link's frame and `body` is not set; meshes have no vertices yet.
struct UrdfParts {
  std::string tree_text;
  std::vector<Shape> collision, visual;
  std::set<std::string> incomplete = {};  ///< links that had a collision mesh which is not there
};

/// Splits a URDF that CheckUrdf has passed. @param scale  by which the lengths of the shapes are multiplied.
UrdfParts SplitUrdf(const std::string& urdf_text, double scale);

}  // namespace gaitwright
