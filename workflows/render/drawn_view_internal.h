// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// A parallel projection of a robot, as a part of a drawing.
///
/// = Notation =
///   D  the plane of the drawing: x along `right_W`, y along `up_W` [m]; px  the picture: x to the right, y down
struct DrawnView {
  std::string title;
  Vector3 right_W = Vector3::UnitX(), up_W = Vector3::UnitZ(), toward_W = -Vector3::UnitY();
  std::string right_label, up_label;  ///< labels of its axes; empty if they are not axes of W
  Eigen::AlignedBox2d extent_D = {};  ///< extent of its content [m]
  double px_per_m = 1.0;
  Vector2 zero_px = Vector2::Zero();  ///< position of the origin of W
  Eigen::AlignedBox2d frame_px = {};  ///< part of the picture for this view

  Vector2 InPlane(const Vector3& p_W) const { return {right_W.dot(p_W), up_W.dot(p_W)}; }
  Vector2 PlaneToPx(const Vector2& p_D) const { return zero_px + px_per_m * Vector2(p_D.x(), -p_D.y()); }
  Vector2 ToPx(const Vector3& p_W) const { return PlaneToPx(InPlane(p_W)); }
};

/// The convex hull of points, enlarged by a radius: a shape of a robot, in W.
struct DrawnSolid {
  std::vector<Vector3> points_W;
  double radius = 0.0;
};

/// Visible shapes of a robot: the visual geometry of each link, or its collision geometry if that is not available.
/// @param mesh_folder  folder to search for meshes of visual geometry. Needs ForwardKinematics on the scratch.
std::vector<DrawnSolid> SolidsOf(const RobotModel& model, const DynamicsScratch& scratch,
                                 const std::string& mesh_folder);

/// The outline of a solid in the plane of a view [m].
std::vector<Vector2> OutlineOf(const DrawnView& view, const DrawnSolid& solid);

/// Solids from back to front, and the lines between joints.
std::string DrawnBody(const DrawnView& view, const RobotModel& model, const DynamicsScratch& scratch,
                      const std::vector<DrawnSolid>& solids);

/// Arrows along the axes of all joints through their origins, with their numbers. Joints behind a parallel one, such as
/// those of the far legs in a side view, are not drawn.
std::string DrawnJoints(const DrawnView& view, const RobotModel& model, const DynamicsScratch& scratch);

/// The style sheet's class of a joint by its axis in W: "jx", "jy", "jz" or "jo" for any other direction.
const char* AxisClass(const Vector3& axis_W);
/// "+y", or the three components of an axis that is not along an axis of W.
std::string AxisText(const Vector3& axis_W);

/// Soles and contact points of the feet, their support polygon, the centre of mass and its projection.
std::string DrawnFeet(const DrawnView& view, const RobotModel& model, const DynamicsScratch& scratch);

}  // namespace gaitwright
