// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <utility>

#include "playback/policy/fit_policy_internal.h"
#include "tests/playback/onnx/written_network.h"
#include "tests/playback/policy/written_contract.h"

namespace gaitwright {
namespace {

using written::ContractText;

constexpr int kObservations = 3 + 3 + 3 + 12 + 12 + 12;

using written::A1;

PolicySource Source(int inputs = kObservations, int outputs = 12) {
  return written::SourceOf(written::ConstantNetwork(inputs, Eigen::VectorXf::Zero(outputs)));
}

std::string FitMessage(const ContractText& contract, const PolicySource& source = Source(),
                       const std::vector<std::string>& order = {}) {
  const Result<FittedPolicy> policy = FitPolicy(A1(), contract.Read(), source, {}, order);
  return policy ? "" : policy.failure().message;
}

TEST(FitPolicyTest, FindsJointsGainsAndTargetsByName) {
  ContractText text(A1());
  std::swap(text.joint_names[0], text.joint_names[3]);  // two hips, with their positions
  std::swap(text.default_position[0], text.default_position[3]);
  const FittedPolicy policy = FitPolicy(A1(), text.Read(), Source(), {}).value();
  ASSERT_EQ(policy.joints.size(), 12U);
  EXPECT_EQ(policy.joints[0].name, A1().dof_names[3]);
  EXPECT_EQ(policy.joints[0].dof, 3);
  EXPECT_EQ(policy.joints[0].stiffness, 100.0);
  ASSERT_EQ(policy.outputs.size(), 12U);
  EXPECT_EQ(policy.outputs[0].scale, 0.25);
  EXPECT_EQ(policy.outputs[0].offset, policy.joints[0].default_position);
  EXPECT_TRUE(policy.held.empty());
}

TEST(FitPolicyTest, TheHardwaresOrderGoesThroughTheMap) {
  ContractText text(A1());
  const std::vector<std::string> names = std::exchange(text.joint_names, {});
  std::string map = "joint_ids_map: [";
  for (int i = 0; i < 12; ++i) map += (i == 0 ? "" : ", ") + std::to_string((i + 3) % 12);
  text.more = map + "]\n";
  std::rotate(text.default_position.begin(), text.default_position.begin() + 3, text.default_position.end());
  const FittedPolicy policy = FitPolicy(A1(), text.Read(), Source(), {}, names).value();
  EXPECT_EQ(policy.joints[0].name, names[3]);
  EXPECT_EQ(policy.joints[11].name, names[2]);
  EXPECT_EQ(FitPolicy(A1(), text.Read(), Source(), {}, {"robot"}).value().joints[0].name, names[3]);
}

TEST(FitPolicyTest, ContractsWithoutNamesAreRefused) {
  ContractText text(A1());
  text.joint_names.clear();
  const std::string message = FitMessage(text);
  EXPECT_NE(message.find("the contract does not name its 12 joints"), std::string::npos) << message;
  EXPECT_NE(message.find("'FR_hip_joint'"), std::string::npos) << message;
}

TEST(FitPolicyTest, SwappedJointsAreRefusedWhereTwoListsOfNamesSayIt) {
  ContractText text(A1());
  const std::vector<std::string> order = text.joint_names;
  std::swap(text.joint_names[0], text.joint_names[3]);
  const std::string message = FitMessage(text, Source(), order);
  const std::string expected = "joint 0 of the network is '" + order[3] + "' by 'joint_names' of the contract, but '" +
                               order[0] + "' by the given joint order";
  EXPECT_NE(message.find(expected), std::string::npos) << message;
}

TEST(FitPolicyTest, NamesInTheNetworkCount) {
  ContractText text(A1());
  written::File file;
  file.inputs = kObservations;
  file.nodes = {written::Node(
      "Slice", {"obs"}, {"action"},
      {written::WholesOf("starts", {0}), written::WholesOf("ends", {12}), written::WholesOf("axes", {1})})};
  std::string names;
  for (const std::string& name : text.joint_names) names += (names.empty() ? "" : ",") + name;
  file.notes = {{"joint_names", names}};
  std::swap(text.joint_names[1], text.joint_names[2]);
  EXPECT_NE(FitMessage(text, written::SourceOf(file.Text())).find("by 'joint_names' in the network"),
            std::string::npos);
  text.joint_names.clear();
  EXPECT_EQ(FitMessage(text, written::SourceOf(file.Text())), "");
}

TEST(FitPolicyTest, SwappedJointsAreRefusedByTheirLimits) {
  ContractText text(A1());
  std::swap(text.joint_names[1], text.joint_names[2]);  // thigh and calf
  const std::string message = FitMessage(text);
  EXPECT_NE(message.find("is outside of its limits"), std::string::npos) << message;
  EXPECT_NE(message.find("the joints may be in another order"), std::string::npos) << message;
}

TEST(FitPolicyTest, UnknownJointsAreRefusedWithTheNearest) {
  ContractText text(A1());
  text.joint_names[0] = "FR_hipp_joint";
  EXPECT_NE(
      FitMessage(text).find("'FR_hipp_joint' of the policy does not exist in 'a1'; the nearest is 'FR_hip_joint'"),
      std::string::npos);
}

TEST(FitPolicyTest, SizesThatDoNotFitTheNetworkAreRefusedByName) {
  const ContractText text(A1());
  EXPECT_NE(FitMessage(text, Source(47))
                .find("the contract gives 45 observations (base_ang_vel 3, projected_gravity 3, "
                      "velocity_commands 3, joint_pos_rel 12, joint_vel_rel 12, last_action 12); "
                      "the network has 47 inputs"),
            std::string::npos);
  EXPECT_NE(FitMessage(text, Source(kObservations, 10)).find("12 actions"), std::string::npos);
  ContractText scaled(A1());
  scaled.action = "scale: [0.25, 0.5]";
  EXPECT_NE(FitMessage(scaled).find("the action's scale has 2 entries; 12 are needed, or one"), std::string::npos);
  ContractText history(A1());
  history.observations = "  joint_pos: {history_length: 3, scale: [1, 2]}\n";
  EXPECT_NE(FitMessage(history, Source(36)).find("the scale of joint_pos has 2 entries"), std::string::npos);
}

TEST(FitPolicyTest, CommandsOutsideOfTheTrainingAreRefused) {
  ContractText text(A1());
  text.more = "commands: {base_velocity: {ranges: {lin_vel_x: [-0.5, 1.0]}}}\n";
  VelocityCommands fast;
  fast.rows[0].speed_m_s = 1.5;
  const Result<FittedPolicy> policy = FitPolicy(A1(), text.Read(), Source(), fast);
  ASSERT_FALSE(policy);
  EXPECT_EQ(policy.failure().message, "the commanded speed_m_s is 1.5; the contract accepts -0.5 to 1");
}

TEST(FitPolicyTest, JointsWithoutAPlaceInTheContractAreHeld) {
  ContractText text(A1());
  text.joint_names.pop_back();
  text.default_position.pop_back();
  text.observations = "  joint_pos: {}\n";
  const FittedPolicy policy = FitPolicy(A1(), text.Read(), Source(11, 11), {}).value();
  EXPECT_EQ(policy.held, std::vector<int>{11});
  ASSERT_FALSE(policy.warnings.empty());
  EXPECT_NE(policy.warnings.back().find("'" + A1().dof_names.back() + "'"), std::string::npos);
}

}  // namespace
}  // namespace gaitwright
