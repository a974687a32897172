// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// Points that, blown up by RoundRadius, span a shape (a sphere: its centre; a capsule: those of its ends), in the
/// body's frame.
std::vector<Vector3> ShapeCorners(const Shape& shape);

/// Of a shape with round ends [m]; 0 for others.
double RoundRadius(const Shape& shape);

/// "the mesh 'foot.stl' of link 'l_foot'", "4 spheres of link 'l_foot'": for people. @param shapes  at least one.
std::string NamesOfShapes(const std::vector<const Shape*>& shapes);

/// The flat bottom of shapes of a foot's body with the body at a pose in the frame O, whose z is up: sole_F, X_BF with
/// O's axes, and derived_from. False where it is no area.
bool FindFlatBottom(const Pose& X_OE, const std::vector<const Shape*>& shapes, Foot& foot);

/// The turn R from level to the plane through what is within 6 mm of the lowest point of shapes, where that is a plane
/// and aslant by less than 0.1 rad; else none. O is as for FindFlatBottom.
Eigen::Quaterniond BottomTilt(const Pose& X_OE, const std::vector<const Shape*>& shapes);

}  // namespace gaitwright
