// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/fcl.h>

#include <memory>

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// A shape as FCL has it; nullptr for a mesh without vertices.
std::shared_ptr<fcl::CollisionGeometryd> FclGeometry(const Shape& shape);

/// How far two placed objects are apart [m], to 1e-5 and never too far; negative by their depth when they touch.
double SignedGap(const fcl::CollisionObjectd& a, const fcl::CollisionObjectd& b);

}  // namespace gaitwright
