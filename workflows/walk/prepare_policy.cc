// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <filesystem>

#include "kinematics/base/file.h"
#include "kinematics/base/hash.h"
#include "planning/terrain/load_terrain.h"
#include "playback/policy/commanded_plan_internal.h"
#include "workflows/walk/prepare_policy_internal.h"

namespace gaitwright {
namespace {

constexpr double kDuration = 10.0, kAfterLast = 5.0;  // [s]
constexpr std::size_t kLargestNetwork = std::size_t{64} << 20, kLargestContract = std::size_t{16} << 20;

Result<PolicySource> ReadSource(const PolicyRequest& request, const std::string& contract) {
  PolicySource source;
  if (request.function) {
    source.name = request.name;
    source.function = request.function;
    source.hash = HexHash(contract);
    return source;
  }
  const Result<std::string> file = ReadBytes(request.network_path, kLargestNetwork);
  if (!file) return file.failure();
  source.name = std::filesystem::path(request.network_path).filename().string();
  Result<Network> network = Network::Read(*file, request.network_path);
  if (!network) return network.failure();
  source.network = std::make_shared<const Network>(std::move(*network));
  source.hash = HexHash(HexHash(*file) + HexHash(contract));
  return source;
}

Result<VelocityCommands> CommandsOf(const PolicyRequest& request) {
  if (request.commands_path.empty()) {
    VelocityCommands constant;
    constant.rows = {request.command};
    constant.rows.front().time_s = 0.0;
    return constant;
  }
  const Result<std::string> text = ReadFile(request.commands_path, kLargestContract);
  if (!text) return text.failure();
  return ReadCommands(*text, request.commands_path);
}

Result<double> DurationOf(const PolicyRequest& request, const VelocityCommands& commands) {
  const double last_s = commands.rows.back().time_s;
  const double duration_s =
      request.duration_s.value_or(request.commands_path.empty() ? kDuration : last_s + kAfterLast);
  if (duration_s > last_s) return duration_s;
  return Failure{FailureKind::kBadInput,
                 FailureCode::kCommand,
                 "PreparePolicy",
                 fmt::format("the duration is {} s, but the last command begins at {} s", duration_s, last_s),
                 {"give a longer --duration, or fewer commands"}};
}

/// Doubts about the start in the default posture.
void AddDoubts(const RobotModel& model, const FittedPolicy& policy, MotionPlan& plan) {
  plan.warnings = policy.warnings;
  const double uneven_m = UnevenFeet(model, policy), most_m = 0.05 * model.leg_length_m();
  if (uneven_m > most_m)
    plan.warnings.push_back(
        fmt::format("in the default posture the feet differ in height by {:.0f} mm; the joints may be in another order",
                    1e3 * uneven_m));
}

}  // namespace

Result<PreparedPolicy> PreparePolicy(const RobotModel& model, const PolicyRequest& request) {
  const Result<std::string> text = ReadFile(request.contract_path, kLargestContract);
  if (!text) return text.failure();
  const Result<PolicyContract> contract = ReadContract(*text, request.contract_path);
  if (!contract) return contract.failure();
  const Result<PolicySource> source = ReadSource(request, *text);
  if (!source) return source.failure();
  const Result<VelocityCommands> commands = CommandsOf(request);
  if (!commands) return commands.failure();
  const Result<double> duration_s = DurationOf(request, *commands);
  if (!duration_s) return duration_s.failure();
  Result<FittedPolicy> policy = FitPolicy(model, *contract, *source, *commands, request.joint_order);
  if (!policy) return policy.failure();
  const Result<Terrain> terrain =
      request.ground ? Result<Terrain>(*request.ground) : LoadTerrain(request.terrain, ScaleOf(model));
  if (!terrain) return terrain.failure();
  PreparedPolicy prepared;
  prepared.plan = CommandedPlan(model, *policy, *terrain, *duration_s);
  AddDoubts(model, *policy, prepared.plan);
  policy->flags = request.flags;
  prepared.policy = std::make_shared<const FittedPolicy>(std::move(*policy));
  return prepared;
}

void UsePolicy(const PreparedPolicy& prepared, PlayRequest& request) {
  request.policy = prepared.policy;
  request.controller = kPolicyController;
}

}  // namespace gaitwright
