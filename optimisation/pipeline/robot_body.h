// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/model/robot_model.h"
#include "optimisation/centroidal/rigid_body_problem.h"
#include "optimisation/whole_body/body_path.h"
#include "planning/footsteps/plan_footsteps.h"

namespace gaitwright {

/// A robot as a single rigid body, in its standing posture.
///
/// = Notation =
///   H  the base frame rotated as in standing on level ground, so z is up and x forward: the frame of the rigid body
struct StandingBody {
  Matrix3 R_HB = Matrix3::Identity();       ///< of the base
  Vector3 p_HC = Vector3::Zero();           ///< centre of mass from the base's origin [m]
  Vector3 p_SB = Vector3::Zero();           ///< horizontal offset of the base from its point on the path [m]
  Matrix3 inertia_H = Matrix3::Identity();  ///< about the centre of mass [kg m^2]
  std::vector<RigidFoot> feet;              ///< positions of the contact frames
};

/// Centre of mass of the standing posture on level ground z = 0, with the base's origin above the world's [m].
Vector3 StandingCentreOfMass(const RobotModel& model);

/// Mass, inertia and feet of the standing posture; workspaces of the legs with a margin (LegPolytope), and the largest
/// vertical force that the motors can hold in this posture.
/// @param reserve  margin, as a share of each joint's range and of the leg length: in [0, 0.2].
StandingBody BodyOf(const RobotModel& model, double reserve);

/// A walk as a problem for a single rigid body: from standing at the start of the path to standing at its end, with the
/// stances of the skeleton's footholds, in order. On level ground, footholds in between are free; on other ground, and
/// while the robot stands still, they are fixed.
RigidBodyProblem ProblemOf(const RobotModel& model, const StandingBody& body, const Terrain& terrain,
                           const FootstepSkeleton& skeleton, const BodyPath& path);

}  // namespace gaitwright
