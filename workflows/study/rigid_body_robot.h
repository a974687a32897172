// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "kinematics/model/robot_model.h"
#include "optimisation/centroidal/rigid_body_problem.h"

namespace gaitwright {

/// A single rigid body as a robot that any judge of robots can look at: the URDF and the robot.yaml of one.
///
/// The trunk has the mass and inertia, its frame's origin in the centre of mass. Each foot hangs on three slides along
/// the trunk's x, y and z; at zero it is at its nominal place, and their limits are its workspace. A foot of three or
/// more points of contact is a sole, and turns against the last slide about z, y and x without limits. Feet weigh
/// `kSlideFoot` each, since nothing can be moved that has no mass; the trunk weighs as much less.
/// A slide pushes as hard as the greatest force on all points of the foot, inside its friction cone, may be. Links are
/// named "foot_0", "foot_1" in the order of the problem's feet, slides "foot_0_x" and so on.
struct RigidBodyTexts {
  std::string urdf, yaml;
};

inline constexpr double kSlideFoot = 1e-7;  ///< [kg]

/// @throws InvalidArgument for a workspace that is not a box along the body's axes, or for two points of contact, or
/// ones that are in no plane through the foot's frame.
RigidBodyTexts RigidBodyTextsOf(const RigidBodyProblem& problem, const std::string& name);

/// The robot of those texts. Failures as those of LoadRobotFromText.
Result<RobotModel> RigidBodyRobot(const RigidBodyProblem& problem, const std::string& name);

/// The problem's foot by each of the robot's, which are in an order of their own. @throws InvalidArgument where the
/// robot is not that of the problem.
std::vector<int> ProblemFeetOf(const RobotModel& robot, const RigidBodyProblem& problem);

/// The box of a workspace: its lowest and its highest corner from the centre of mass [m], in B.
/// @throws InvalidArgument where it is none, or has no end to some side.
std::pair<Vector3, Vector3> BoxOf(const std::vector<WorkspaceSide>& workspace_B);

}  // namespace gaitwright
