// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "playback/policy/fit_policy_internal.h"
#include "workflows/walk/walk.h"

namespace gaitwright {

/// A learned policy, its contract, its commands, and where it is played.
struct PolicyRequest {
  std::string network_path;         ///< ONNX file; "" if `function` is given
  PolicyFunction function = {};     ///< a policy of the caller's
  std::string name = "a function";  ///< of the function
  std::string contract_path;
  std::string commands_path;             ///< "" for the constant command
  TimedCommand command = {};             ///< constant command, without a file
  std::optional<double> duration_s;      ///< default: 10 s, or 5 s after the last command of a file
  std::vector<std::string> joint_order;  ///< see FitPolicy
  std::string flags;                     ///< see FittedPolicy
  std::string terrain = "flat";
  std::optional<Terrain> ground = {};  ///< instead of `terrain`
};

/// A policy that fits the robot, and its command as a plan.
struct PreparedPolicy {
  std::shared_ptr<const FittedPolicy> policy;
  MotionPlan plan;
};

/// Reads and fits a policy.
/// @return the failures of the readers and of FitPolicy; a failure for a duration that ends before the last command.
Result<PreparedPolicy> PreparePolicy(const RobotModel& model, const PolicyRequest& request);

/// Adds the policy to a playback request, as its controller.
void UsePolicy(const PreparedPolicy& prepared, PlayRequest& request);

}  // namespace gaitwright
