// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/model/robot_model.h"
#include "optimisation/centroidal/rigid_body_problem.h"
#include "optimisation/whole_body/body_path.h"
#include "planning/footsteps/plan_footsteps.h"

namespace gaitwright {

/// A robot as a single rigid body: what it is in its standing posture.
///
/// = Notation =
///   H  the base turned as it is in standing on level ground, so that z is up and x ahead: the frame of the rigid body
struct StandingBody {
  Matrix3 R_HB = Matrix3::Identity();       ///< of the base
  Vector3 p_HC = Vector3::Zero();           ///< centre of mass from the base's origin [m]
  Vector3 p_SB = Vector3::Zero();           ///< the base from where it stands on the path, level [m]
  Matrix3 inertia_H = Matrix3::Identity();  ///< about the centre of mass [kg m^2]
  std::vector<RigidFoot> feet;              ///< the places of their contact frames
};

/// Centre of mass of the standing posture on level ground z = 0, the base's origin over the world's [m].
Vector3 StandingCentreOfMass(const RobotModel& model);

/// Mass, inertia and feet of the standing posture; the workspaces of the legs with a reserve (LegPolytope), and the
/// greatest upright force that the motors hold in that posture.
/// @param reserve  share of each joint's range, and of the leg, that is kept free: in [0, 0.2].
StandingBody BodyOf(const RobotModel& model, double reserve);

/// A walk as a problem for a single rigid body: from standing at the start of the path to standing at its end, the
/// stances those of the skeleton's footholds, in their order. On level ground those in between may be anywhere; on
/// other ground, and where the robot stands still, feet are held to theirs.
RigidBodyProblem ProblemOf(const RobotModel& model, const StandingBody& body, const Terrain& terrain,
                           const FootstepSkeleton& skeleton, const BodyPath& path);

}  // namespace gaitwright
