// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "playback/policy/fit_policy_internal.h"
#include "tests/playback/policy/written_contract.h"

namespace gaitwright {
namespace {

FittedPolicy ShownPolicy() {
  written::ContractText text(written::A1());
  text.observations = "  joint_pos_rel: {history_length: 5, clip: [-3, 3]}\n  gait_phase: {params: {period: 0.6}}\n";
  const PolicySource source = written::SourceOf(written::ConstantNetwork(62, Eigen::VectorXf::Zero(12)));
  return FitPolicy(written::A1(), text.Read(), source, {}).value();
}

TEST(PolicyTextTest, ShowsNamesOrderSizesAndGains) {
  const std::string text = PolicyText(written::A1(), ShownPolicy());
  for (const char* part : {"policy 'policy.onnx' for 'a1': 62 observations, 12 actions, every 0.02 s", "Gemm x 1",
                           "FR_hip_joint", "RL_calf_joint", "clip -3 to 3", "period 0.6 s", "12 x 5"})
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
}

TEST(PolicyTextTest, JsonHasTheSame) {
  const auto json = nlohmann::json::parse(PolicyJson(written::A1(), ShownPolicy()));
  EXPECT_EQ(json.at("observations"), 62);
  EXPECT_EQ(json.at("joints").size(), 12U);
  EXPECT_EQ(json.at("joints")[0].at("name"), written::A1().dof_names.front());
  EXPECT_EQ(json.at("joints")[0].at("stiffness_nm_rad"), 100.0);
  EXPECT_EQ(json.at("terms")[0].at("history"), 5);
}

}  // namespace
}  // namespace gaitwright
