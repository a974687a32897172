// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/spatial/rotation.h"
#include "kinematics/stability/polygon.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// ContactFrame and ContactPoints of kinematics/dynamics/foot_contact.h with the normal of the ground under the foot.
/// They need ForwardKinematics.
Pose ContactFrame(const RobotModel& model, const DynamicsScratch& scratch, const Terrain& terrain, int foot);
std::vector<Vector3> ContactPoints(const RobotModel& model, const DynamicsScratch& scratch, const Terrain& terrain,
                                   int foot);

/// Support of the robot: the soles of a set of feet at their poses, with or without contact.
struct Support {
  std::vector<Vector3> points_W;          ///< contact points, in the order of the feet
  Polygon polygon;                        ///< hull in plan view of the sole parts on their patches
  Vector3 reference_W = Vector3::Zero();  ///< their mean
  Vector3 normal_W = Vector3::UnitZ();    ///< mean normal of the ground below them
  double base_yaw_rad = 0.0;              ///< heading if the points alone do not define one
  bool coplanar = true;  ///< whether the ground under the points is plane to 5 mm; only then a ZMP exists
  bool tilts = false;    ///< one sole alone whose leg has no ankle roll joint, so that it stands on any of its edges

  bool empty() const { return points_W.empty(); }
};

/// @param on_edge  feet of the stance that stand on their soles' front edges.
/// @pre ForwardKinematics of `scratch`.
Support SupportOf(const RobotModel& model, const DynamicsScratch& scratch, const Terrain& terrain, FootSet stance,
                  FootSet on_edge = 0);

/// Height of a support's plane at a point in plan view.
double PlaneHeight(const Support& support, const Vector2& p_W);

/// True if the polygon is wider than 1 mm on average and its feet can hold the ZMP inside it. Otherwise it is a line or
/// a point, or a sole that tilts.
bool HasArea(const Support& support);

/// Planar rigid motion from one support to the same support at another place.
struct SupportMotion {
  Vector2 from_W = Vector2::Zero(), to_W = Vector2::Zero();  ///< the reference points
  double yaw_rad = 0.0;

  /// Moves a point near `to` to the corresponding place near `from`.
  Vector2 Back(const Vector2& p_W) const;
};

/// The motion that moves the points of `planned` nearest to those of `measured` in plan view (least squares); a single
/// point turns with the base. @pre both have the same feet.
SupportMotion MotionBetween(const Support& planned, const Support& measured);

}  // namespace gaitwright
