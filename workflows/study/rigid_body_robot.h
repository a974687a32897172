// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "kinematics/model/robot_model.h"
#include "optimisation/centroidal/rigid_body_problem.h"

namespace gaitwright {

/// A single rigid body as a robot (URDF and robot.yaml), so that the audit of robots applies to it.
///
/// The trunk has the mass and inertia; the origin of its frame is the centre of mass. Each foot has three prismatic
/// joints along the trunk's x, y and z; at zero it is at its nominal position, and the joint limits are its workspace.
/// A foot with three or more contact points is a sole and rotates relative to the last prismatic joint about z, y and x
/// without limits. Each foot has the mass `kSlideFoot`, because a moving link needs a mass; the trunk's mass is reduced
/// accordingly. The effort limit of a prismatic joint is the largest force inside the friction cone over all contact
/// points of the foot. Links are named "foot_0", "foot_1" in the order of the problem's feet, prismatic joints
/// "foot_0_x" and so on.
struct RigidBodyTexts {
  std::string urdf, yaml;
};

inline constexpr double kSlideFoot = 1e-7;  ///< [kg]

/// @throws InvalidArgument for a workspace that is not a box along the body's axes, for two contact points, or for
/// contact points that do not lie in a plane through the foot's frame.
RigidBodyTexts RigidBodyTextsOf(const RigidBodyProblem& problem, const std::string& name);

/// The robot of RigidBodyTextsOf. Failures as of LoadRobotFromText.
Result<RobotModel> RigidBodyRobot(const RigidBodyProblem& problem, const std::string& name);

/// The problem's foot for each of the robot's feet, whose order may differ. @throws InvalidArgument if the robot does
/// not belong to the problem.
std::vector<int> ProblemFeetOf(const RobotModel& robot, const RigidBodyProblem& problem);

/// The box of a workspace: its lowest and its highest corner from the centre of mass [m], in B.
/// @throws InvalidArgument if it is not a box, or is unbounded.
std::pair<Vector3, Vector3> BoxOf(const std::vector<WorkspaceSide>& workspace_B);

}  // namespace gaitwright
