// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "kinematics/base/file.h"
#include "kinematics/spatial/rotation.h"
#include "tests/built_paths.h"
#include "tests/playback/onnx/written_network.h"
#include "tests/playback/policy/written_contract.h"
#include "tests/scratch_folder.h"
#include "workflows/study/run_trials.h"
#include "workflows/walk/prepare_policy_internal.h"

namespace gaitwright {
namespace {

using written::A1;

/// Files of a policy in a folder.
class PreparePolicyTest : public testing::Test {
 protected:
  static std::string Write(const std::string& name, const std::string& text) {
    std::string path = ScratchFile(name);
    EXPECT_TRUE(WriteFileAtomically(path, text).ok());
    return path;
  }

  /// The policy of the examples, which trots.
  static PolicyRequest Trotting() {
    const std::string base = SourceFolder() + "/examples/policies/a1_trot";
    PolicyRequest request;
    request.network_path = base + ".onnx";
    request.contract_path = base + ".yaml";
    return request;
  }

  /// A policy that stands: its output is zero.
  static PolicyRequest Standing() {
    PolicyRequest request;
    request.network_path = Write("policy.onnx", written::ConstantNetwork(45, Eigen::VectorXf::Zero(12)));
    request.contract_path = Write("deploy.yaml", written::ContractText(A1()).Yaml());
    request.duration_s = 5.0;
    return request;
  }
};

PlayRequest PlayOf(const PreparedPolicy& prepared, const std::string& engine) {
  PlayRequest request;
  request.play.world.engine = engine;
  UsePolicy(prepared, request);
  return request;
}

TEST_F(PreparePolicyTest, APolicyThatHoldsItsPostureStandsInEachEngine) {
  const PreparedPolicy prepared = PreparePolicy(A1(), Standing()).value();
  const PlayedWalk played = PlayWalk(A1(), prepared.plan, PlayOf(prepared, ProvingEngine())).value();
  EXPECT_TRUE(played.report.pass) << played.report.reason;
  EXPECT_EQ(played.log.controller, "policy");
  EXPECT_LT(*played.report.At("command_velocity_error_m_s").value, 0.01);
  if (played.second != nullptr) {
    EXPECT_TRUE(played.second->report.pass) << played.second->report.reason;
  }
}

TEST_F(PreparePolicyTest, APolicyThatStepsFollowsItsCommandInEachEngine) {
  PolicyRequest request = Trotting();
  request.command.speed_m_s = 0.3;
  request.duration_s = 6.0;
  const PreparedPolicy prepared = PreparePolicy(A1(), request).value();
  const PlayedWalk played = PlayWalk(A1(), prepared.plan, PlayOf(prepared, ProvingEngine())).value();
  EXPECT_TRUE(played.report.pass) << played.report.reason;
  EXPECT_GT(*played.report.At("distance_m").value, 1.5);
  if (played.second != nullptr) {
    EXPECT_TRUE(played.second->report.pass) << played.second->report.reason;
  }
}

TEST_F(PreparePolicyTest, CommandsChangeOverTime) {
  PolicyRequest request = Trotting();
  request.commands_path = Write("turn.csv", "time_s,speed_m_s,yaw_rate_rad_s\n0,0,0\n1,0.2,0\n3,0.2,0.3\n");
  request.duration_s = 6.0;
  const PreparedPolicy prepared = PreparePolicy(A1(), request).value();
  EXPECT_NEAR(prepared.plan.goal.yaw_rad, 0.9, 1e-9);
  const PlayedWalk played = PlayWalk(A1(), prepared.plan, PlayOf(prepared, "bullet")).value();
  EXPECT_TRUE(played.report.At("command_velocity_error_m_s").pass) << played.report.reason;
  EXPECT_TRUE(played.report.At("command_yaw_rate_error_rad_s").pass) << played.report.reason;
  const double yaw = YawOf(BaseRotation(played.log.samples.back().q));
  EXPECT_GT(yaw, 0.5);
  EXPECT_EQ(*played.report.At("fell").value, 0.0);
}

TEST_F(PreparePolicyTest, AFunctionGivesTheSamePlayback) {
  PolicyRequest request = Standing();
  const PreparedPolicy network = PreparePolicy(A1(), request).value();
  request.network_path = "";
  request.function = [](const Eigen::VectorXf&) { return Eigen::VectorXf::Zero(12).eval(); };
  const PreparedPolicy function = PreparePolicy(A1(), request).value();
  const PlayedWalk a = PlayWalk(A1(), network.plan, PlayOf(network, "bullet")).value();
  const PlayedWalk b = PlayWalk(A1(), function.plan, PlayOf(function, "bullet")).value();
  EXPECT_EQ(SamplesHash(a.log), SamplesHash(b.log));
}

TEST_F(PreparePolicyTest, ItGetsTrialsLikeAPlan) {
  const PreparedPolicy prepared = PreparePolicy(A1(), Standing()).value();
  const PlayRequest request = PlayOf(prepared, "bullet");
  const Disturbances disturbances = StandardBesides(A1(), request);
  TrialOptions options;
  options.trials = 3;
  const RobustnessReport report = RunTrials({A1(), prepared.plan, request, disturbances}, options).value();
  EXPECT_EQ(report.n, 3);
  EXPECT_EQ(report.subject.controller, "policy");
  EXPECT_NE(report.subject.repeat.find("--policy POLICY --contract CONTRACT"), std::string::npos);
  const RobustnessReport again = RunTrials({A1(), prepared.plan, request, disturbances}, options).value();
  EXPECT_EQ(RobustnessJson(report), RobustnessJson(again));
}

TEST_F(PreparePolicyTest, OtherFilesGiveOtherPlans) {
  PolicyRequest request = Standing();
  const MotionPlan plan = PreparePolicy(A1(), request).value().plan;
  request.network_path = Write("other.onnx", written::ConstantNetwork(45, Eigen::VectorXf::Constant(12, 0.1F)));
  const MotionPlan other = PreparePolicy(A1(), request).value().plan;
  EXPECT_NE(plan.provenance.options, other.provenance.options);
}

TEST_F(PreparePolicyTest, SwappedJointsShowInTheStart) {
  PolicyRequest request = Standing();
  written::ContractText text(A1());
  text.default_position[2] = -1.2;  // one calf
  request.contract_path = Write("swapped.yaml", text.Yaml());
  const MotionPlan plan = PreparePolicy(A1(), request).value().plan;
  ASSERT_FALSE(plan.warnings.empty());
  EXPECT_NE(plan.warnings.back().find("the joints may be in another order"), std::string::npos);
}

TEST_F(PreparePolicyTest, RefusesMissingFilesAndShortDurations) {
  PolicyRequest request = Standing();
  request.commands_path = Write("c.csv", "time_s,speed_m_s\n0,0\n6,0\n");
  const Result<PreparedPolicy> early = PreparePolicy(A1(), request);
  ASSERT_FALSE(early);
  EXPECT_EQ(early.failure().message, "the duration is 5 s, but the last command begins at 6 s");
  request.duration_s.reset();
  EXPECT_NEAR(PreparePolicy(A1(), request).value().plan.duration_s(), 11.0, 1e-9);
  request.network_path = ScratchFile("none.onnx");
  EXPECT_FALSE(PreparePolicy(A1(), request));
}

}  // namespace
}  // namespace gaitwright
