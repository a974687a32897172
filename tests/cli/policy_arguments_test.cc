// SPDX-License-Identifier: BSD-3-Clause
// `gaitwright play` and `trials` with a learned policy.
#include "tests/cli/stranger.h"
#include "tests/playback/onnx/written_network.h"
#include "tests/playback/policy/written_contract.h"

namespace gaitwright::cli {
namespace {

class Policies : public Stranger {
 protected:
  Policies() : contract_(written::A1()) {
    Write("policy.onnx", written::ConstantNetwork(45, Eigen::VectorXf::Zero(12)));
    Write("deploy.yaml", contract_.Yaml());
  }

  static std::vector<std::string> With(const std::string& verb, const std::vector<std::string>& more) {
    std::vector<std::string> words = {verb, "--policy", "policy.onnx", "--contract", "deploy.yaml"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }

  written::ContractText contract_;
};

TEST_F(Policies, AreShownBeforeTheyArePlayed) {
  const Ran ran = Run(With("play", {"--duration", "1", "--report", "r.html", "--log", "log.json"}));
  ASSERT_EQ(ran.status, 0) << ran.out << ran.err;
  const std::size_t table = ran.out.find("FR_hip_joint"), verdict = ran.out.find("PASS");
  EXPECT_LT(table, verdict) << ran.out;
  EXPECT_NE(ran.out.find("command_velocity_error_m_s"), std::string::npos);
  EXPECT_NE(ran.out.find("a learned policy has no plan to audit"), std::string::npos);
  EXPECT_NE(Read("r.html").find("a learned policy"), std::string::npos);
}

TEST_F(Policies, JsonHasTheTable) {
  const Json json = Run(With("play", {"--duration", "1", "--json"})).json();
  EXPECT_EQ(json.at("policy").at("joints").size(), 12U);
  EXPECT_EQ(json.at("files").at("policy"), "policy.onnx");
  EXPECT_EQ(json.at("verdict"), "pass");
  EXPECT_TRUE(json.at("metrics").at("zmp_margin_p05_m").at("value").is_null());
}

TEST_F(Policies, ATrialIsRepeatedByItsSeed) {
  const Ran ran = Run(With("trials", {"--duration", "1", "-n", "2", "--threads", "1", "--json"}));
  ASSERT_EQ(ran.status, 0) << ran.err;
  const Json json = ran.json();
  EXPECT_NE(json.at("repeat").get<std::string>().find("--policy POLICY --contract CONTRACT --robot a1 --duration 1"),
            std::string::npos);
  const Json worst = json.at("worst").at(0);
  const std::string seed = std::to_string(worst.at("seed").get<int>());
  const Json played =
      Run(With("play", {"--duration", "1", "--disturbances", "standard", "--seed", seed, "--json"})).json();
  EXPECT_EQ(played.at("score"), worst.at("score"));
}

TEST_F(Policies, CommandsComeFromAFile) {
  Write("commands.csv", "time_s,speed_m_s\n0,0\n1,0.5\n");
  const Json json = Run(With("play", {"--commands", "commands.csv", "--duration", "2", "--json"})).json();
  EXPECT_NEAR(json.at("metrics").at("distance_m").at("planned").get<double>(), 0.5, 1e-6);
  EXPECT_EQ(json.at("verdict"), "fail");  // the policy stands
}

TEST_F(Policies, WhatDoesNotFitIsRefused) {
  ExpectRefused(Run({"play"}), 1, {"nothing to play", "--policy"});
  ExpectRefused(Run({"play", "--policy", "policy.onnx"}), 1, {"--contract"});
  ExpectRefused(Run({"play", "--speed", "1"}), 1, {"--policy"});
  ExpectRefused(Run(With("play", {"--robot", "nao"})), 1, {"_hip_joint'", "does not exist in 'nao'"});
  ExpectRefused(Run(With("play", {"--set", "stabilised.dcm_gain=1"})), 1, {"stabilised.dcm_gain", "no effect"});
  Write("policy.onnx", written::ConstantNetwork(47, Eigen::VectorXf::Zero(12)));
  ExpectRefused(Run(With("play", {})), 1, {"45 observations", "47 inputs"});
  std::swap(contract_.joint_names[1], contract_.joint_names[2]);
  Write("deploy.yaml", contract_.Yaml());
  ExpectRefused(Run(With("play", {})), 1, {"outside of its limits", "another order"});
}

}  // namespace
}  // namespace gaitwright::cli
