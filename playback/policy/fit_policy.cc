// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <set>
#include <sstream>

#include "kinematics/base/nearest_name.h"
#include "kinematics/base/text.h"
#include "playback/policy/fit_policy_internal.h"
#include "playback/policy/observations_internal.h"

namespace gaitwright {
namespace {

/// One number for all, or one for each.
template <class T>
const T& Each(const std::vector<T>& list, std::size_t i) {
  return list[list.size() == 1 ? 0 : i];
}

/// Names that the exporter of a network wrote into it: a list with commas.
std::vector<std::string> NotedNames(const PolicySource& source) {
  std::vector<std::string> names;
  if (source.network == nullptr) return names;
  const auto found = source.network->notes().find("joint_names");
  if (found == source.network->notes().end()) return names;
  std::istringstream stream(found->second);
  for (std::string name; std::getline(stream, name, ',');) names.push_back(Trimmed(name));
  return names;
}

/// A list of names in the network's order, and where it comes from.
struct NamedOrder {
  std::string from;
  std::vector<std::string> names;
};

/// Names in the hardware's order, brought into the network's order.
NamedOrder FromHardware(const std::string& from, const std::vector<std::string>& names,
                        const PolicyContract& contract) {
  NamedOrder order{from, {}};
  for (int i = 0; i < contract.num_joints(); ++i) {
    const auto index = static_cast<std::size_t>(contract.HardwareIndex(i));
    if (index >= names.size())
      throw InvalidArgument(fmt::format("{} has {} names; joint {} of the network is number {} of the hardware", from,
                                        names.size(), i, index));
    order.names.push_back(names[index]);
  }
  return order;
}

std::vector<NamedOrder> OrdersOf(const RobotModel& model, const PolicyContract& contract, const PolicySource& source,
                                 const std::vector<std::string>& order) {
  std::vector<NamedOrder> orders;
  if (!contract.joint_names.empty()) orders.push_back({"'joint_names' of the contract", contract.joint_names});
  if (!contract.hardware_names.empty())
    orders.push_back(FromHardware("'joint_sdk_names' of the contract", contract.hardware_names, contract));
  const bool own = order.size() == 1 && order.front() == "robot";
  if (!order.empty()) orders.push_back(FromHardware("the given joint order", own ? model.dof_names : order, contract));
  if (std::vector<std::string> noted = NotedNames(source); !noted.empty())
    orders.push_back({"'joint_names' in the network", std::move(noted)});
  return orders;
}

/// The names of the joints in the network's order. @throws InvalidArgument if they are unknown or contradict each
/// other.
std::vector<std::string> NamesOf(const RobotModel& model, const PolicyContract& contract, const PolicySource& source,
                                 const std::vector<std::string>& order) {
  const std::vector<NamedOrder> orders = OrdersOf(model, contract, source, order);
  if (orders.empty())
    throw InvalidArgument(fmt::format(
        "the contract does not name its {} joints; give their names in the order of its stiffness (joint_sdk_names in "
        "the contract, or --joint-order), or --joint-order robot if that is the robot's own order: {}",
        contract.num_joints(), QuotedList(model.dof_names)));
  const NamedOrder& first = orders.front();
  for (const NamedOrder& other : orders) {
    if (other.names.size() != static_cast<std::size_t>(contract.num_joints()))
      throw InvalidArgument(fmt::format("{} has {} names; the contract has {} joints", other.from, other.names.size(),
                                        contract.num_joints()));
    for (std::size_t i = 0; i < first.names.size(); ++i) {
      if (other.names[i] != first.names[i])
        throw InvalidArgument(fmt::format("joint {} of the network is '{}' by {}, but '{}' by {}", i, first.names[i],
                                          first.from, other.names[i], other.from));
    }
  }
  return first.names;
}

PolicyJoint JointOf(const RobotModel& model, const PolicyContract& contract, int index, const std::string& name) {
  const auto found = std::find(model.dof_names.begin(), model.dof_names.end(), name);
  if (found == model.dof_names.end())
    throw InvalidArgument(
        fmt::format("joint '{}' of the policy does not exist in '{}'{}", name, model.name,
                    NearestOrAll(name, model.dof_names, "'gaitwright robots show' lists all joints")));
  const auto i = static_cast<std::size_t>(index), at = static_cast<std::size_t>(contract.HardwareIndex(index));
  PolicyJoint joint{name, static_cast<int>(found - model.dof_names.begin()), contract.stiffness[at],
                    contract.damping[at], contract.default_position[i]};
  constexpr double kRounding = 1e-6;
  const double low = model.dof_lower(joint.dof), high = model.dof_upper(joint.dof);
  if (joint.default_position < low - kRounding || joint.default_position > high + kRounding)
    throw InvalidArgument(fmt::format(
        "the default position {:.4g} rad of '{}' is outside of its limits {:.4g} to {:.4g} in '{}'; the joints may be "
        "in another order",
        joint.default_position, name, low, high, model.name));
  return joint;
}

void CheckIndices(const char* what, const std::vector<int>& indices, int joints) {
  for (const int index : indices) {
    if (index >= joints)
      throw InvalidArgument(fmt::format("{} names joint {}; the contract has joints 0 to {}", what, index, joints - 1));
  }
}

void CheckSize(const std::string& what, std::size_t count, std::size_t needed) {
  if (count != 1 && count != needed)
    throw InvalidArgument(fmt::format("{} has {} entries; {} are needed, or one", what, count, needed));
}

std::vector<PolicyOutput> OutputsOf(const PolicyContract& contract, const std::vector<PolicyJoint>& joints) {
  const PolicyAction& action = contract.action;
  CheckIndices("the action's joint_ids", action.joints, contract.num_joints());
  const std::size_t count = action.joints.empty() ? joints.size() : action.joints.size();
  CheckSize("the action's scale", action.scale.size(), count);
  if (!action.offset.empty()) CheckSize("the action's offset", action.offset.size(), count);
  if (!action.clip.empty()) CheckSize("the action's clip", action.clip.size(), count);
  std::vector<PolicyOutput> outputs;
  for (std::size_t i = 0; i < count; ++i) {
    const int joint = action.joints.empty() ? static_cast<int>(i) : action.joints[i];
    PolicyOutput output{joint, Each(action.scale, i), joints[static_cast<std::size_t>(joint)].default_position};
    if (!action.offset.empty()) output.offset = Each(action.offset, i);
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    const PolicyRange clip = action.clip.empty() ? PolicyRange{-kInfinity, kInfinity} : Each(action.clip, i);
    output.lowest = clip.lowest;
    output.highest = clip.highest;
    outputs.push_back(output);
  }
  return outputs;
}

/// "base_ang_vel 3 x 5, joint_pos_rel 12 x 5"
std::string TermsText(const PolicyContract& contract, int actions) {
  std::string text;
  for (const ObservationTerm& term : contract.observations) {
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", term.name, SizeOf(term, contract.num_joints(), actions));
    if (term.history > 1) text += fmt::format(" x {}", term.history);
  }
  return text;
}

void CheckObservations(const PolicyContract& contract, const PolicySource& source, int actions) {
  constexpr int kMostObservations = 1000000;
  std::int64_t all = 0;
  for (const ObservationTerm& term : contract.observations) {
    CheckIndices(("joint_ids of " + term.name).c_str(), term.joints, contract.num_joints());
    const int size = SizeOf(term, contract.num_joints(), actions);
    CheckSize("the scale of " + term.name, term.scale.size(), static_cast<std::size_t>(size));
    all += std::int64_t{size} * term.history;
  }
  if (all > kMostObservations)
    throw InvalidArgument(fmt::format("the contract has {} observations; accepted: up to {}", all, kMostObservations));
  if (source.network == nullptr) return;
  if (source.network->input_size() != all)
    throw InvalidArgument(fmt::format("the contract gives {} observations ({}); the network has {} inputs", all,
                                      TermsText(contract, actions), source.network->input_size()));
  if (source.network->output_size() != actions)
    throw InvalidArgument(
        fmt::format("the contract gives {} actions, one for each joint that is moved; the network has "
                    "{} outputs",
                    actions, source.network->output_size()));
}

void CheckCommands(const PolicyContract& contract, const VelocityCommands& commands) {
  const auto check = [](const char* what, double value, const std::optional<PolicyRange>& range) {
    constexpr double kRounding = 1e-9;
    if (range && (value < range->lowest - kRounding || value > range->highest + kRounding))
      throw InvalidArgument(fmt::format("the commanded {} is {}; the contract accepts {} to {}", what, value,
                                        range->lowest, range->highest));
  };
  for (const TimedCommand& row : commands.rows) {
    check("speed_m_s", row.speed_m_s, contract.speed_m_s);
    check("lateral_speed_m_s", row.lateral_speed_m_s, contract.lateral_speed_m_s);
    check("yaw_rate_rad_s", row.yaw_rate_rad_s, contract.yaw_rate_rad_s);
  }
}

void AddWarnings(const RobotModel& model, FittedPolicy& policy) {
  for (const PolicyJoint& joint : policy.joints) {
    if (joint.stiffness == 0.0)
      policy.warnings.push_back(
          fmt::format("the stiffness of '{}' is 0, so that its target has no effect", joint.name));
  }
  for (std::size_t i = 0; i < policy.outputs.size(); ++i) {
    const PolicyOutput& output = policy.outputs[i];
    const PolicyJoint& joint = policy.joints[static_cast<std::size_t>(output.joint)];
    if (output.offset != joint.default_position)
      policy.warnings.push_back(fmt::format("the action's offset of '{}' is {}, its default position {}", joint.name,
                                            output.offset, joint.default_position));
  }
  if (!policy.held.empty()) {
    std::vector<std::string> names;
    for (const int dof : policy.held) names.push_back(model.dof_names[static_cast<std::size_t>(dof)]);
    policy.warnings.push_back("these joints are not in the contract and are held in the standing posture: " +
                              QuotedList(names));
  }
}

FittedPolicy Fitted(const RobotModel& model, const PolicyContract& contract, const PolicySource& source,
                    const std::vector<std::string>& order) {
  FittedPolicy policy;
  policy.contract = contract;
  policy.source = source;
  const std::vector<std::string> names = NamesOf(model, contract, source, order);
  std::set<int> found;
  for (int i = 0; i < contract.num_joints(); ++i) {
    policy.joints.push_back(JointOf(model, contract, i, names[static_cast<std::size_t>(i)]));
    if (!found.insert(policy.joints.back().dof).second)
      throw InvalidArgument(fmt::format("joint '{}' is given twice", policy.joints.back().name));
  }
  for (int dof = 0; dof < model.num_dofs(); ++dof) {
    if (!found.contains(dof)) policy.held.push_back(dof);
  }
  policy.outputs = OutputsOf(contract, policy.joints);
  CheckObservations(contract, source, static_cast<int>(policy.outputs.size()));
  AddWarnings(model, policy);
  return policy;
}

Failure BadFit(FailureCode code, const PolicySource& source, const RobotModel& model, const std::string& why) {
  return {FailureKind::kBadInput,
          code,
          "FitPolicy",
          fmt::format("policy '{}' does not fit '{}': {}", source.name, model.name, why),
          {"docs/policies.md explains the contract"}};
}

}  // namespace

Result<FittedPolicy> FitPolicy(const RobotModel& model, const PolicyContract& contract, const PolicySource& source,
                               const VelocityCommands& commands, const std::vector<std::string>& order) {
  Result<FittedPolicy> policy = [&]() -> Result<FittedPolicy> {
    try {
      return Fitted(model, contract, source, order);
    } catch (const InvalidArgument& error) {
      return BadFit(FailureCode::kMisfit, source, model, error.what());
    }
  }();
  if (!policy) return policy;
  try {
    CheckCommands(contract, commands);
  } catch (const InvalidArgument& error) {
    return Failure{FailureKind::kBadInput,
                   FailureCode::kCommand,
                   "FitPolicy",
                   error.what(),
                   {"command speeds that the policy was trained on"}};
  }
  policy->commands = commands;
  return policy;
}

}  // namespace gaitwright
