// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "kinematics/model/robot_model.h"
#include "playback/onnx/network_internal.h"
#include "playback/policy/contract_internal.h"
#include "playback/policy/velocity_commands_internal.h"

namespace gaitwright {

/// A policy as a function: observation in, action out. It gives an action of the right size.
using PolicyFunction = std::function<Eigen::VectorXf(const Eigen::VectorXf& observation)>;

/// A policy before it is fitted to a robot: either a network or a function.
struct PolicySource {
  std::string name;  ///< in messages and reports
  std::string hash;  ///< of its file and contract, for provenance
  std::shared_ptr<const Network> network = nullptr;
  PolicyFunction function = {};
};

/// A joint of the network, in its order, and the robot's coordinate that it is.
struct PolicyJoint {
  std::string name;
  int dof = 0;
  double stiffness = 0.0, damping = 0.0;  ///< [N m/rad], [N m s/rad]
  double default_position = 0.0;          ///< [rad]
};

/// The target of a joint for one output of the network.
struct PolicyOutput {
  int joint = 0;  ///< index in FittedPolicy::joints
  double scale = 1.0, offset = 0.0;
  double lowest = 0.0, highest = 0.0;
};

/// A policy that fits a robot. Immutable; threads may share it unless its source is a function.
struct FittedPolicy {
  PolicyContract contract;
  PolicySource source;
  VelocityCommands commands;
  std::vector<PolicyJoint> joints;    ///< in the network's order
  std::vector<PolicyOutput> outputs;  ///< in the order of the network's outputs
  std::vector<int> held;              ///< coordinates of the robot that are not in the contract
  std::string flags;                  ///< robot, commands and ground as flags of `play`, to repeat a trial
  std::vector<std::string> warnings;  ///< what is doubtful, but does not prevent a playback
};

/// The policy for a robot: joints found by their names, sizes of network and contract compared, positions compared with
/// the robot's limits, commands compared with the ranges of the contract.
///
/// The names are those of the contract (`joint_names`, `joint_sdk_names`), else `order` (names in the hardware's order,
/// or the one word "robot" for the robot's own order), else those that the exporter wrote into the network
/// (`joint_names`). If several are given, they must agree.
/// @return a failure kMisfit that names the joint, the observations or the size that do not fit; kCommand for a command
/// out of range.
Result<FittedPolicy> FitPolicy(const RobotModel& model, const PolicyContract& contract, const PolicySource& source,
                               const VelocityCommands& commands, const std::vector<std::string>& order = {});

/// Names, orders, sizes and gains as a table, for people to check before the first step.
std::string PolicyText(const RobotModel& model, const FittedPolicy& policy);
/// The same as a JSON object.
std::string PolicyJson(const RobotModel& model, const FittedPolicy& policy);

}  // namespace gaitwright
