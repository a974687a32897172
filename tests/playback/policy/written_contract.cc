// SPDX-License-Identifier: BSD-3-Clause
#include "tests/playback/policy/written_contract.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "tests/playback/onnx/written_network.h"

namespace gaitwright::written {

ContractText::ContractText(const RobotModel& model) : joint_names(model.dof_names) {
  const VectorX standing = StandingConfiguration(model).tail(model.num_dofs());
  default_position.assign(standing.data(), standing.data() + standing.size());
}

std::string ContractText::Yaml() const {
  const std::size_t n = default_position.size();
  const std::vector<double> kp(n, stiffness), kd(n, damping);
  return fmt::format(
      "{}step_dt: {}\nstiffness: [{}]\ndamping: [{}]\ndefault_joint_pos: [{}]\nactions:\n  JointPositionAction: "
      "{{{}}}\n"
      "observations:\n{}{}",
      joint_names.empty() ? "" : fmt::format("joint_names: [{}]\n", fmt::join(joint_names, ", ")), step_s,
      fmt::join(kp, ", "), fmt::join(kd, ", "), fmt::join(default_position, ", "), action, observations, more);
}

PolicyContract ContractText::Read() const { return ReadContract(Yaml(), "contract.yaml").value(); }

std::string ConstantNetwork(int inputs, const Eigen::VectorXf& output) {
  return DenseNetwork({{Eigen::MatrixXf::Zero(output.size(), inputs), output}}, "Elu");
}

PolicySource SourceOf(const std::string& file) {
  PolicySource source;
  source.name = "policy.onnx";
  source.hash = "0123456789abcdef";
  source.network = std::make_shared<const Network>(NetworkOf(file));
  return source;
}

}  // namespace gaitwright::written
