// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// Points that, blown up by RoundingRadius, span a shape (a sphere: its centre; a capsule: those of its ends), in the
/// body's frame.
std::vector<Vector3> SpanningCorners(const Shape& shape);

/// Radius of a shape with round ends [m]; 0 for others.
double RoundingRadius(const Shape& shape);

/// "the mesh 'foot.stl' of link 'l_foot'", "4 spheres of link 'l_foot'": for people.
std::string NameOfShapes(const std::vector<const Shape*>& shapes);

/// The largest give that a user may ask for [m].
inline constexpr double kLargestSoleGive = 0.05;

/// The flat bottom of shapes of a foot's body in a posture: its corners, frame and what it is derived from. It is what
/// of the shapes lies within the sole's give of their lowest point, as rubber gives: of a mesh 2 % of its length, from
/// 2 to 6 mm, so that the hull of a rounded sole has the area that people see; of other shapes 2 mm.
/// @param X_OE          the body's pose in the frame O, whose z is up and whose axes X_BF has then.
/// @param given_give_m  a give in place of those, for shapes of any kind, from 0 to kLargestSoleGive.
/// @return whether there is one: three points or more that are no line, and of a mesh 1 cm^2 or more.
bool FindFlatBottom(const Pose& X_OE, const std::vector<const Shape*>& shapes, std::optional<double> given_give_m,
                    Foot& foot);

/// The turn R from level to the plane through what is within 6 mm of the lowest point of shapes, where that is a plane
/// and aslant by less than 0.1 rad; else none. O is as for FindFlatBottom.
Eigen::Quaterniond BottomTilt(const Pose& X_OE, const std::vector<const Shape*>& shapes);

}  // namespace gaitwright
