// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// Points in the body's frame whose convex hull, enlarged by RoundingRadius, is the shape. For a sphere this is its
/// centre, for a capsule the centres of its ends.
std::vector<Vector3> SpanningCorners(const Shape& shape);

/// Radius of a sphere or capsule [m]; 0 for other shapes.
double RoundingRadius(const Shape& shape);

/// Description of shapes for messages: "the mesh 'foot.stl' of link 'l_foot'", "4 spheres of link 'l_foot'".
std::string NameOfShapes(const std::vector<const Shape*>& shapes);

/// Largest accepted value of `sole_give_m` [m].
inline constexpr double kLargestSoleGive = 0.05;

/// Finds the flat bottom of the shapes of a foot's body in a posture. Sets its corners, its frame and its source. The
/// bottom consists of the points up to a height, the give of the rubber, above the lowest point. The give is 2 % of the
/// length of a mesh, limited to 2 to 6 mm, so that a rounded sole has its visible area; for other shapes it is 2 mm.
/// @param X_OE          the body's pose in the frame O; z of O is up, and X_BF gets the axes of O.
/// @param given_give_m  replaces these values, for shapes of any kind; from 0 to kLargestSoleGive.
/// @return whether there is a flat bottom: three or more points that are not on a line, and 1 cm^2 or more for a mesh.
bool FindFlatBottom(const Pose& X_OE, const std::vector<const Shape*>& shapes, std::optional<double> given_give_m,
                    Foot& foot);

/// Rotation from level to the plane through the points of the shapes within 6 mm of the lowest one. Identity if these
/// points are not in a plane, or if the plane is tilted by more than 0.1 rad. O is as in FindFlatBottom.
Eigen::Quaterniond BottomTilt(const Pose& X_OE, const std::vector<const Shape*>& shapes);

}  // namespace gaitwright
