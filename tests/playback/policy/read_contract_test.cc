// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "playback/policy/contract_internal.h"

namespace gaitwright {
namespace {

/// As Unitree's training writes it, for three joints of a robot with motors 0, 1 and 4.
constexpr char kDeploy[] = R"(joint_ids_map: [4, 0, 1]
step_dt: 0.02
stiffness: [100.0, 150.0, 40.0]
damping: [2.0, 4.0, 1.0]
default_joint_pos: [-0.1, 0.3, 0.97]
commands:
  base_velocity:
    ranges:
      lin_vel_x: [-0.5, 1.0]
      lin_vel_y: [-0.3, 0.3]
      ang_vel_z: [-0.2, 0.2]
      heading: null
actions:
  JointPositionAction:
    clip: null
    joint_names: [.*]
    scale: [0.25, 0.25, 0.5]
    offset: [-0.1, 0.3, 0.97]
    joint_ids: null
observations:
  base_ang_vel:
    params: {}
    clip: null
    scale: [0.2, 0.2, 0.2]
    history_length: 5
  velocity_commands:
    params: {command_name: base_velocity}
    clip: [-100.0, 100.0]
    scale: [1.0, 1.0, 1.0]
    history_length: 5
  gait_phase:
    params: {period: 0.8}
    clip: null
    scale: [1.0, 1.0]
    history_length: 0
)";

std::string Replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

std::string ContractMessage(const std::string& text) {
  const Result<PolicyContract> contract = ReadContract(text, "c.yaml");
  return contract ? "" : contract.failure().message;
}

TEST(ReadContractTest, ReadsWhatUnitreesTrainingWrites) {
  const PolicyContract c = ReadContract(kDeploy, "deploy.yaml").value();
  EXPECT_EQ(c.step_s, 0.02);
  EXPECT_EQ(c.num_joints(), 3);
  EXPECT_EQ(c.speed_m_s, (PolicyRange{-0.5, 1.0}));
  EXPECT_EQ(c.yaw_rate_rad_s, (PolicyRange{-0.2, 0.2}));
  EXPECT_EQ(c.action.scale, (std::vector<double>{0.25, 0.25, 0.5}));
  EXPECT_TRUE(c.action.clip.empty());
  ASSERT_EQ(c.observations.size(), 3U);
  EXPECT_EQ(c.observations[0].name, "base_ang_vel");
  EXPECT_EQ(c.observations[0].history, 5);
  EXPECT_EQ(c.observations[1].clip, (PolicyRange{-100.0, 100.0}));
  EXPECT_EQ(c.observations[2].history, 1);
  EXPECT_EQ(c.observations[2].period_s, 0.8);
  EXPECT_FALSE(c.history_by_frame);
}

TEST(ReadContractTest, GainsAreInTheHardwaresOrder) {
  const PolicyContract c = ReadContract(kDeploy, "deploy.yaml").value();
  EXPECT_EQ(c.HardwareIndex(0), 2);  // the highest of motors 0, 1 and 4
  EXPECT_EQ(c.HardwareIndex(1), 0);
  const std::string all =
      Replaced(Replaced(kDeploy, "[100.0, 150.0, 40.0]", "[1, 2, 3, 4, 5]"), "[2.0, 4.0, 1.0]", "[1, 1, 1, 1, 1]");
  EXPECT_EQ(ReadContract(all, "deploy.yaml").value().HardwareIndex(0), 4);
}

TEST(ReadContractTest, OneNumberStandsForAll) {
  const std::string text = Replaced(kDeploy, "scale: [0.25, 0.25, 0.5]", "scale: 0.25");
  EXPECT_EQ(ReadContract(text, "c").value().action.scale, std::vector<double>{0.25});
}

TEST(ReadContractTest, NamesUnknownObservationsAndKeys) {
  EXPECT_EQ(ContractMessage(Replaced(kDeploy, "base_ang_vel:", "base_ang_speed:")).find("'c.yaml', line 21: "), 0U);
  EXPECT_NE(ContractMessage(Replaced(kDeploy, "base_ang_vel:", "base_ang_speed:")).find("'base_ang_vel'"),
            std::string::npos);
  EXPECT_NE(ContractMessage(Replaced(kDeploy, "base_ang_vel:", "height_scan:")).find("height_scan"), std::string::npos);
  EXPECT_NE(ContractMessage(Replaced(kDeploy, "JointPositionAction", "JointEffortAction")).find("JointEffortAction"),
            std::string::npos);
  EXPECT_NE(ContractMessage(Replaced(kDeploy, "step_dt", "step_td")).find("'step_dt'"), std::string::npos);
}

TEST(ReadContractTest, RefusesListsThatContradictEachOther) {
  EXPECT_NE(ContractMessage(Replaced(kDeploy, "[4, 0, 1]", "[4, 0]")).find("'joint_ids_map' has 2 entries"),
            std::string::npos);
  EXPECT_NE(ContractMessage(Replaced(kDeploy, "[4, 0, 1]", "[4, 0, 0]")).find("has an entry twice"), std::string::npos);
  EXPECT_NE(ContractMessage(Replaced(kDeploy, "[2.0, 4.0, 1.0]", "[2.0, 4.0]")).find("'damping' has 2 entries"),
            std::string::npos);
  EXPECT_NE(ContractMessage(Replaced(kDeploy, "[-0.5, 1.0]", "[1.0, -0.5]")).find("the lower end comes first"),
            std::string::npos);
  EXPECT_NE(ContractMessage(Replaced(kDeploy, "{period: 0.8}", "{}")).find("has no period"), std::string::npos);
}

TEST(ReadContractTest, RefusesNumbersOutOfRange) {
  EXPECT_NE(ContractMessage(Replaced(kDeploy, "step_dt: 0.02", "step_dt: 0")), "");
  EXPECT_NE(ContractMessage(Replaced(kDeploy, "150.0, 40.0", "-150.0, 40.0")), "");
  EXPECT_NE(ContractMessage(Replaced(kDeploy, "history_length: 5", "history_length: -1")), "");
  EXPECT_NE(ContractMessage("[1]"), "");
}

TEST(ReadContractTest, FramesNeedOneHistory) {
  const std::string frames = Replaced(kDeploy, "observations:\n", "observations:\n  use_gym_history: true\n");
  EXPECT_NE(ContractMessage(frames).find("needs one history_length"), std::string::npos);
  EXPECT_TRUE(ReadContract(Replaced(frames, "history_length: 0", "history_length: 5"), "c").value().history_by_frame);
}

}  // namespace
}  // namespace gaitwright
