// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace gaitwright {

/// Replaces each ball joint (type `spherical`, used in Bullet's URDFs) by three continuous joints about x, y and z of
/// its frame, in that order from the parent: `NAME_x`, `NAME_y`, `NAME_z`. The links between them, `CHILD_x` and
/// `CHILD_y`, have no mass. The three joints are singular if the middle one is a quarter turn from zero.
/// @param urdf_text  must have passed CheckUrdf.
/// @return the text itself if it has no ball joint.
std::string WithoutBallJoints(const std::string& urdf_text);

}  // namespace gaitwright
