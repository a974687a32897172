// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/paths.h"
#include "cli/program.h"
#include "cli/robot_input.h"
#include "cli/verb.h"
#include "planning/audit/audit.h"
#include "workflows/walk/prepare_policy_internal.h"

namespace gaitwright::cli {

/// What is played: a plan, or a policy with its command as a plan.
struct PlayedInput {
  RobotModel model;
  MotionPlan plan;
  std::optional<PreparedPolicy> prepared = {};  ///< of a policy; its plan is moved to `plan`
};

/// Prints names, order, sizes and gains of a policy, for people to check before the first step; nothing for a plan.
void PrintPolicy(const PlayedInput& input, const Common& common);

/// The audit of a plan. A policy's command has nothing to audit.
Result<AuditReport> AuditOf(const PlayedInput& input);

/// The argument PLAN, and the flags of a learned policy that may replace it. Shared by `play` and `trials`.
struct PolicyArguments {
  std::string plan;
  RobotFlags robot;
  PolicyRequest request;
  std::string joint_order;

  void AddTo(Verb verb);
  bool is_policy() const { return !request.network_path.empty(); }
  /// @throws InvalidArgument unless there is either a plan or a policy with its contract.
  void Check() const;
  void AddPathsTo(Paths& paths) const;
  /// Reads the plan and its robot, or the policy and the chosen robot.
  Result<PlayedInput> Read();
  /// Of the input, for results: {"plan", FILE}, or {"policy", FILE} and {"contract", FILE}.
  std::vector<std::pair<std::string, std::string>> Files() const;
};

}  // namespace gaitwright::cli
