// SPDX-License-Identifier: BSD-3-Clause
// Contracts for tests.
#pragma once

#include <string>
#include <vector>

#include "kinematics/model/robot_model.h"
#include "playback/policy/fit_policy_internal.h"
#include "tests/named_robot.h"

namespace gaitwright::written {

inline const RobotModel& A1() { return NamedRobot("a1"); }

/// The text of a contract for a robot in its standing posture, with the joints in the robot's order.
struct ContractText {
  explicit ContractText(const RobotModel& model);

  std::vector<std::string> joint_names;
  std::vector<double> default_position;
  double stiffness = 100.0, damping = 2.0, step_s = 0.02;
  std::string action = "scale: 0.25";  ///< keys of JointPositionAction
  std::string observations =
      "  base_ang_vel: {scale: 0.2}\n  projected_gravity: {}\n  velocity_commands: {}\n  joint_pos_rel: {}\n"
      "  joint_vel_rel: {scale: 0.05}\n  last_action: {}\n";
  std::string more;  ///< further lines

  std::string Yaml() const;
  PolicyContract Read() const;
};

/// A network whose output is constant.
std::string ConstantNetwork(int inputs, const Eigen::VectorXf& output);

/// A source with a network from the text of its file.
PolicySource SourceOf(const std::string& file);

}  // namespace gaitwright::written
