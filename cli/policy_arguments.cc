// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <sstream>

#include "cli/flags.h"
#include "cli/policy_arguments_internal.h"
#include "planning/plan/plan_json.h"

namespace gaitwright::cli {
namespace {

std::vector<std::string> WithoutCommas(const std::string& list) {
  std::vector<std::string> names;
  std::istringstream stream(list);
  for (std::string name; std::getline(stream, name, ',');) names.push_back(name);
  return names;
}

/// The flags that a trial of the policy is repeated with.
std::string RepeatFlags(const PolicyArguments& a) {
  const PolicyRequest& r = a.request;
  std::string flags = a.robot.is_file()
                          ? fmt::format("{} {}", EndingOf(a.robot.file) == ".xml" ? "--mjcf" : "--urdf", a.robot.file)
                          : "--robot " + a.robot.name;
  if (!a.joint_order.empty()) flags += " --joint-order " + a.joint_order;
  if (!r.commands_path.empty()) flags += " --commands " + r.commands_path;
  for (const auto& [flag, value] : {std::pair("speed", r.command.speed_m_s),
                                    {"lateral-speed", r.command.lateral_speed_m_s},
                                    {"yaw-rate", r.command.yaw_rate_rad_s}})
    if (value != 0.0) flags += fmt::format(" --{} {}", flag, value);
  if (r.duration_s) flags += fmt::format(" --duration {}", *r.duration_s);
  if (r.terrain != PolicyRequest().terrain) flags += " --terrain " + r.terrain;
  return flags;
}

}  // namespace

void PrintPolicy(const PlayedInput& input, const Common& common) {
  if (input.prepared && !common.json && !common.quiet)
    fmt::print("{}\n", PolicyText(input.model, *input.prepared->policy));
}

Result<AuditReport> AuditOf(const PlayedInput& input) {
  if (!input.prepared) return Audit(input.model, input.plan, AuditOptions{});
  AuditReport none;
  none.notes = {"a learned policy has no plan to audit"};
  return none;
}

void PolicyArguments::AddTo(Verb verb) {
  const Flag file =
      AddText(verb, "PLAN", "FILE", plan, "A plan file, as written by 'plan' and 'walk'; not with --policy.");
  verb.SetGroup("Learned policy, instead of PLAN");
  const Flag policy = AddText(verb, "--policy", "FILE", request.network_path,
                              "A policy to play instead of a plan, an ONNX file, see docs/policies.md; default none.");
  const Flag contract =
      AddText(verb, "--contract", "FILE", request.contract_path,
              "The policy's contract, such as Unitree's deploy.yaml; needed with --policy; default none.");
  policy.Need(contract).Exclude(file);
  std::vector<Flag> flags = robot.AddTo(verb);
  flags.push_back(contract);
  flags.push_back(AddText(verb, "--joint-order", "NAMES", joint_order,
                          "Names of the robot's joints in the order of the contract's stiffness, with commas, or "
                          "'robot' for the robot's own order; default: the names in the contract or the network."));
  const Flag commands = AddText(verb, "--commands", "FILE", request.commands_path,
                                "Velocity commands over time, a CSV or YAML file; default: a constant command.");
  const Flag speed = AddNumber(verb, "--speed", "m/s", request.command.speed_m_s, "Forward speed; default 0.");
  const Flag lateral = AddNumber(verb, "--lateral-speed", "m/s", request.command.lateral_speed_m_s,
                                 "Lateral speed; positive is to the left; default 0.");
  const Flag turning = AddNumber(verb, "--yaw-rate", "rad/s", request.command.yaw_rate_rad_s,
                                 "Yaw rate; positive is to the left; default 0.");
  for (const Flag& flag : {speed, lateral, turning}) {
    commands.Exclude(flag);
    flags.push_back(flag);
  }
  flags.push_back(commands);
  flags.push_back(AddNumber(verb, "--duration", "s", request.duration_s,
                            "Duration of the playback; default 10, or 5 after the last command of --commands."));
  flags.push_back(
      AddText(verb, "--terrain", "NAME", request.terrain, "Ground by name or file, as for 'walk'; default flat."));
  for (const Flag& flag : flags) flag.Need(policy);
}

void PolicyArguments::Check() const {
  if (plan.empty() && !is_policy())
    throw InvalidArgument("nothing to play: give a PLAN file, or --policy with --contract");
}

void PolicyArguments::AddPathsTo(Paths& paths) const {
  if (!is_policy()) return paths.Read("the plan", plan);
  paths.Read("--policy", request.network_path);
  paths.Read("--contract", request.contract_path);
  paths.Read("--commands", request.commands_path);
  paths.AddTerrain(request.terrain);
  robot.AddTo(paths);
}

Result<PlayedInput> PolicyArguments::Read() {
  if (!is_policy()) {
    Result<MotionPlan> read = LoadPlan(plan);
    if (!read) return read.failure();
    Result<RobotModel> model = RobotOf(*read);
    if (!model) return model.failure();
    return PlayedInput{std::move(*model), std::move(*read)};
  }
  Result<RobotModel> model = ReadRobot(robot);
  if (!model) return model.failure();
  request.joint_order = WithoutCommas(joint_order);
  request.flags = RepeatFlags(*this);
  Result<PreparedPolicy> prepared = PreparePolicy(*model, request);
  if (!prepared) return prepared.failure();
  MotionPlan command = std::move(prepared->plan);
  return PlayedInput{std::move(*model), std::move(command), std::move(*prepared)};
}

std::vector<std::pair<std::string, std::string>> PolicyArguments::Files() const {
  if (!is_policy()) return {{"plan", plan}};
  return {{"policy", request.network_path}, {"contract", request.contract_path}};
}

}  // namespace gaitwright::cli
