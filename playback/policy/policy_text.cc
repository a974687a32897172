// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "playback/policy/fit_policy_internal.h"
#include "playback/policy/observations_internal.h"

namespace gaitwright {
namespace {

/// One number if all are equal, else their list.
std::string ListText(const std::vector<double>& list) {
  for (const double number : list) {
    if (number != list.front()) return fmt::format("[{:.4g}]", fmt::join(list, ", "));
  }
  return list.empty() ? "" : fmt::format("{:.4g}", list.front());
}

std::string TermText(const FittedPolicy& policy, const ObservationTerm& term) {
  const int size = SizeOf(term, policy.contract.num_joints(), static_cast<int>(policy.outputs.size()));
  std::string text =
      fmt::format("  {:<18} {:>4} x {:<3} scale {}", term.name, size, term.history, ListText(term.scale));
  if (term.clip) text += fmt::format(", clip {:.4g} to {:.4g}", term.clip->lowest, term.clip->highest);
  if (term.period_s) text += fmt::format(", period {:.4g} s", *term.period_s);
  return text;
}

std::string OutputText(const FittedPolicy& policy, int joint) {
  for (std::size_t i = 0; i < policy.outputs.size(); ++i) {
    const PolicyOutput& output = policy.outputs[i];
    if (output.joint == joint) return fmt::format("{:>6} {:>8.4g} {:>8.4g}", i, output.scale, output.offset);
  }
  return fmt::format("{:>6} {:>8} {:>8}", "none", "", "");
}

int HardwareNumber(const PolicyContract& contract, int joint) {
  return contract.joint_ids_map.empty() ? joint : contract.joint_ids_map[static_cast<std::size_t>(joint)];
}

}  // namespace

std::string PolicyText(const RobotModel& model, const FittedPolicy& policy) {
  const PolicyContract& contract = policy.contract;
  const int actions = static_cast<int>(policy.outputs.size());
  std::string text = fmt::format("policy '{}' for '{}': {} observations, {} actions, every {:.4g} s\n",
                                 policy.source.name, model.name, SizeOf(contract, actions), actions, contract.step_s);
  if (const Network* network = policy.source.network.get())
    text += fmt::format("network: {}; {} parameters\n", network->operators(), network->parameters());
  text += fmt::format("\n{:>7} {:>8}  {:<28} {:>8} {:>9} {:>8} {:>6} {:>8} {:>8}\n", "network", "hardware", "joint",
                      "default", "stiffness", "damping", "output", "scale", "offset");
  for (std::size_t i = 0; i < policy.joints.size(); ++i) {
    const PolicyJoint& joint = policy.joints[i];
    const int index = static_cast<int>(i);
    text += fmt::format("{:>7} {:>8}  {:<28} {:>8.4g} {:>9.4g} {:>8.4g} {}\n", i, HardwareNumber(contract, index),
                        joint.name, joint.default_position, joint.stiffness, joint.damping, OutputText(policy, index));
  }
  text += "\nobservations, in the order of the network's inputs\n";
  for (const ObservationTerm& term : contract.observations) text += TermText(policy, term) + "\n";
  if (contract.history_by_frame) text += "  all observations of the oldest time come first\n";
  for (const std::string& warning : policy.warnings) text += fmt::format("warning: {}\n", warning);
  return text;
}

std::string PolicyJson(const RobotModel& model, const FittedPolicy& policy) {
  using Json = nlohmann::ordered_json;
  const PolicyContract& contract = policy.contract;
  const int actions = static_cast<int>(policy.outputs.size());
  Json json = {{"name", policy.source.name},
               {"hash", policy.source.hash},
               {"robot", model.name},
               {"step_s", contract.step_s},
               {"observations", SizeOf(contract, actions)},
               {"actions", actions}};
  json["terms"] = Json::array();
  for (const ObservationTerm& term : contract.observations)
    json["terms"].push_back(
        {{"name", term.name}, {"size", SizeOf(term, contract.num_joints(), actions)}, {"history", term.history}});
  json["joints"] = Json::array();
  for (std::size_t i = 0; i < policy.joints.size(); ++i) {
    const PolicyJoint& joint = policy.joints[i];
    json["joints"].push_back({{"name", joint.name},
                              {"hardware", HardwareNumber(contract, static_cast<int>(i))},
                              {"default_position_rad", joint.default_position},
                              {"stiffness_nm_rad", joint.stiffness},
                              {"damping_nm_s_rad", joint.damping}});
  }
  json["warnings"] = policy.warnings;
  return json.dump();
}

}  // namespace gaitwright
