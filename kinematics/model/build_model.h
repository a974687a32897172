// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "kinematics/model/robot_model.h"
#include "kinematics/model/urdf_shapes.h"

namespace gaitwright {

/// An inertia that is used in place of the file's.
struct LinkInertia {
  std::string link;
  Matrix3 I = Matrix3::Zero();  ///< about the link's centre of mass, in the axes of the link [kg m^2]
};

/// Bodies, joints, frames and shapes of a URDF that CheckUrdf has passed; legs and posture are left empty. Fixed joints
/// are merged into their parents with their frames kept by name; the rest is in document order made topological. An
/// inertia that is zero, equal for all links, or far too large for the link (see MendOversizedInertia) is replaced by
/// that of the link's shapes.
/// @param scale  by which the tree's lengths are multiplied; those of the shapes have it already. Masses and inertias
/// stay, as they do in Bullet. A joint beyond which nothing has inertia about its axis is
/// fixed, and where `strict` a failure. Failure: urdfdom refuses it (with its reason), or it has no mass.
Result<RobotModel> BuildModel(const UrdfParts& parts, const std::string& name, double scale, bool strict = false);

/// Inertias with which BuildModel replaces those of the tree, except rounding changes; empty if it is refused.
std::vector<LinkInertia> InertiasUsed(const UrdfParts& parts, double scale);

}  // namespace gaitwright
