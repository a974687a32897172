// SPDX-License-Identifier: BSD-3-Clause
#include "tests/fuzz/policy_readers.h"

#include <cmath>

#include "playback/onnx/network_internal.h"
#include "playback/policy/contract_internal.h"
#include "playback/policy/observations_internal.h"
#include "playback/policy/velocity_commands_internal.h"

namespace gaitwright::fuzz {
namespace {

Verdict ReadNetwork(const std::string& input) {
  const Result<Network> network = Network::Read(input, "input");
  if (!network) return Verdict::kRefused;
  Require(network->input_size() >= 0 && network->output_size() >= 0, "sizes are not negative");
  NetworkScratch scratch = network->MakeScratch();
  const Eigen::VectorXf observation = Eigen::VectorXf::Constant(network->input_size(), 0.5F);
  Eigen::VectorXf first(network->output_size()), again(network->output_size());
  network->Evaluate(observation, scratch, first);
  network->Evaluate(observation, scratch, again);
  for (Eigen::Index i = 0; i < first.size(); ++i)
    Require(first[i] == again[i] || (std::isnan(first[i]) && std::isnan(again[i])), "an evaluation repeats");
  return Verdict::kAccepted;
}

Verdict ReadContractFile(const std::string& input) {
  const Result<PolicyContract> contract = ReadContract(input, "input");
  if (!contract) return Verdict::kRefused;
  Require(contract->step_s > 0.0 && std::isfinite(contract->step_s), "a step has a time");
  Require(contract->damping.size() == contract->stiffness.size(), "gains belong together");
  for (int i = 0; i < contract->num_joints(); ++i) {
    const int index = contract->HardwareIndex(i);
    Require(index >= 0 && index < static_cast<int>(contract->stiffness.size()), "each joint has gains");
  }
  Require(!contract->observations.empty(), "there are observations");
  for (const ObservationTerm& term : contract->observations)
    Require(term.history >= 1 && !ObservationMeaning(term.name).empty(), "observations are known");
  return Verdict::kAccepted;
}

Verdict ReadCommandsFile(const std::string& input) {
  Verdict verdict = Verdict::kRefused;
  for (const char* name : {"input.csv", "input.yaml"}) {
    const Result<VelocityCommands> commands = ReadCommands(input, name);
    if (!commands) continue;
    verdict = Verdict::kAccepted;
    Require(!commands->rows.empty() && commands->rows.front().time_s == 0.0, "commands begin at 0");
    for (std::size_t i = 0; i < commands->rows.size(); ++i) {
      Require(commands->rows[i].AsVector().allFinite(), "commands are finite");
      Require(i == 0 || commands->rows[i].time_s > commands->rows[i - 1].time_s, "times are sorted");
    }
  }
  return verdict;
}

std::vector<std::string> MadeContracts() {
  return {
      "joint_ids_map: [1, 0]\nstep_dt: 0.02\nstiffness: [100, 50]\ndamping: [2, 1]\ndefault_joint_pos: [0.1, -0.2]\n"
      "commands: {base_velocity: {ranges: {lin_vel_x: [-1, 1], heading: null}}}\n"
      "actions: {JointPositionAction: {scale: [0.25, 0.5], offset: 0, clip: [[-1, 1], [-2, 2]], joint_ids: null}}\n"
      "observations:\n  use_gym_history: false\n  base_ang_vel: {params: {}, clip: [-10, 10], scale: 0.2, "
      "history_length: 5}\n  joint_pos_rel: {params: {asset_cfg: {joint_ids: [1]}}}\n  gait_phase: {params: "
      "{period: 0.8}}\n",
      "joint_names: [a, b]\njoint_sdk_names: [a, b]\nstep_dt: 0.005\nstiffness: [1, 2]\ndamping: [0, 0]\n"
      "default_joint_pos: [0, 0]\nactions: {JointPositionAction: {}}\nobservations: {last_action: {}}\n"};
}

std::vector<std::string> MadeCommands() {
  return {"time_s,speed_m_s,lateral_speed_m_s,yaw_rate_rad_s\n0,0.5,0,0\n2.5,-0.25,0.1,0.3\n",
          "- {time_s: 0, speed_m_s: 0.5}\n- {time_s: 2.5, yaw_rate_rad_s: -0.3}\n"};
}

}  // namespace

Reader NetworkReader() {
  return {"network",
          ReadNetwork,
          {"Gemm", "Elu", "Slice", "Concat", "Reshape", "obs", "action", "transB", "axis", "\x08", "\x12", "\x1a",
           "\xff\xff\xff\xff\xff\xff\xff\xff\xff\x01"},
          {}};
}

Reader ContractReader() {
  return {"policy_contract",
          ReadContractFile,
          {"null", "[]", "{}", "-1", "1e400", ".nan", "joint_ids", "clip", "scale", "history_length", "params", "true"},
          {},
          MadeContracts};
}

Reader CommandsReader() {
  return {"policy_commands",
          ReadCommandsFile,
          {"time_s", "speed_m_s", "nan", "inf", "-1", "1e400", ",", "\n"},
          {},
          MadeCommands};
}

}  // namespace gaitwright::fuzz
