// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
#include <string>
#include <vector>

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// A URDF in two parts: its tree, as a URDF without geometry, and its shapes. Each shape has the name of its link, X_BS
/// is its pose in the frame of that link, `body` is not set, and meshes have no vertices yet.
struct UrdfParts {
  std::string tree_text;
  std::vector<Shape> collision, visual;
  std::set<std::string> incomplete = {};  ///< links with a missing collision mesh
};

/// Splits a URDF that CheckUrdf has passed. @param scale  factor on the lengths of the shapes.
UrdfParts SplitUrdf(const std::string& urdf_text, double scale);

}  // namespace gaitwright
