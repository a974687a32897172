// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/fcl.h>

#include <memory>

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// The FCL geometry of a shape; nullptr for a mesh without vertices.
std::shared_ptr<fcl::CollisionGeometryd> FclGeometry(const Shape& shape);

/// Distance of two placed objects [m], accurate to 1e-5 and never too large; the negative depth if they touch.
double SignedGap(const fcl::CollisionObjectd& a, const fcl::CollisionObjectd& b);

}  // namespace gaitwright
