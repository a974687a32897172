// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace gaitwright {

/// A URDF that CheckUrdf has passed, with each ball joint (type `spherical`, of Bullet's URDFs) as three continuous
/// joints about x, y and z of its frame, in that order from the parent: `NAME_x`, `NAME_y`, `NAME_z`, with links
/// without mass between, `CHILD_x` and `CHILD_y`. They are singular where the middle one is a quarter turn from zero.
/// @return the text itself where it has none.
std::string WithoutBallJoints(const std::string& urdf_text);

}  // namespace gaitwright
