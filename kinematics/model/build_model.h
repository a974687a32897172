// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "kinematics/model/robot_model.h"
#include "kinematics/model/urdf_shapes.h"

namespace gaitwright {

/// An inertia that replaces the inertia in the file.
struct LinkInertia {
  std::string link;
  Matrix3 I = Matrix3::Zero();  ///< about the link's centre of mass, in the axes of the link [kg m^2]
};

/// Bodies, joints, frames and shapes of a URDF that CheckUrdf has passed; legs and posture are left empty. Links behind
/// fixed joints are merged into their parents, and their frames are kept by name. Joints are in document order, changed
/// only so that parents come first. An inertia that is zero, equal for all links, or far too large for the link (see
/// MendOversizedInertia) is replaced by the inertia of the link's shapes. A joint is fixed if nothing beyond it has
/// inertia about its axis.
/// @param scale  factor on the lengths of the tree; the shapes are already scaled. Masses and inertias are not scaled,
/// as in Bullet.
/// @param strict  refuses a joint that would be fixed and an inertia that would be replaced.
/// @return Failure: urdfdom refuses the tree (with its reason), or the robot has no mass.
Result<RobotModel> BuildModel(const UrdfParts& parts, const std::string& name, double scale, bool strict = false);

/// The inertias that BuildModel replaces, with their replacements, except changes by rounding; empty if the tree is
/// refused.
std::vector<LinkInertia> InertiasUsed(const UrdfParts& parts, double scale);

}  // namespace gaitwright
