// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "playback/policy/policy_controller_internal.h"
#include "tests/playback/policy/written_contract.h"

namespace gaitwright {
namespace {

using written::A1;

/// Records its observations and gives an action that counts its calls.
struct Recorder {
  std::vector<Eigen::VectorXf> seen;

  PolicySource Source() {
    PolicySource source;
    source.name = "recorder";
    source.function = [this](const Eigen::VectorXf& observation) {
      seen.push_back(observation);
      return Eigen::VectorXf::Constant(12, static_cast<float>(seen.size()));
    };
    return source;
  }
};

std::shared_ptr<const FittedPolicy> Fitted(const written::ContractText& text, const PolicySource& source) {
  return std::make_shared<const FittedPolicy>(FitPolicy(A1(), text.Read(), source, {}).value());
}

ControlInput InputAt(double time_s) {
  ControlInput input;
  input.time_s = time_s;
  input.q = StandingConfiguration(A1());
  input.v = VectorX::Zero(A1().nv());
  return input;
}

TEST(PolicyControllerTest, HoldsTheDefaultPostureUntilTheClockGoes) {
  Recorder recorder;
  const written::ContractText text(A1());
  PolicyController controller(A1(), Fitted(text, recorder.Source()), 0.0, {});
  for (int k = 0; k < 200; ++k) controller.Update(InputAt(0.0));
  EXPECT_TRUE(recorder.seen.empty());
  const JointCommand command = controller.Update(InputAt(0.0));
  for (int i = 0; i < 12; ++i) EXPECT_EQ(command.q[i], text.default_position[static_cast<std::size_t>(i)]);
  EXPECT_EQ(command.stiffness, VectorX::Constant(12, 100.0));
  EXPECT_EQ(command.damping, VectorX::Constant(12, 2.0));
  EXPECT_TRUE(command.tau_ff.isZero(0.0));
}

TEST(PolicyControllerTest, AsksThePolicyOnceInEachStep) {
  Recorder recorder;
  const written::ContractText text(A1());
  PolicyController controller(A1(), Fitted(text, recorder.Source()), 0.0, {});
  JointCommand command;
  for (int k = 0; k <= 100; ++k) command = controller.Update(InputAt(0.001 * k));
  ASSERT_EQ(recorder.seen.size(), 6U);  // at 0.001, 0.02, 0.04, ..., 0.1 s
  EXPECT_NEAR(command.q[0], text.default_position[0] + 0.25 * 6.0, 1e-6);
  EXPECT_TRUE(recorder.seen[0].tail(12).isZero(0.0F));
  EXPECT_TRUE(recorder.seen[1].tail(12).isConstant(1.0F));  // last_action
}

TEST(PolicyControllerTest, TargetsAreClipped) {
  Recorder recorder;
  written::ContractText text(A1());
  text.action = "scale: 0.25, clip: [-0.5, 0.5]";
  PolicyController controller(A1(), Fitted(text, recorder.Source()), 0.0, {});
  JointCommand command;
  for (int k = 0; k <= 200; ++k) command = controller.Update(InputAt(0.001 * k));
  EXPECT_EQ(command.q[0], 0.5);
}

TEST(PolicyControllerTest, AResetRepeatsThePlayback) {
  const written::ContractText text(A1());
  const PolicySource source =
      written::SourceOf(written::ConstantNetwork(45, Eigen::VectorXf::LinSpaced(12, -1.0F, 1.0F)));
  PolicyController controller(A1(), Fitted(text, source), 0.0, {});
  const VectorX first = controller.Update(InputAt(0.001)).q;
  controller.Update(InputAt(0.5));
  controller.Reset();
  EXPECT_NE(controller.Update(InputAt(0.0)).q, first);
  EXPECT_EQ(controller.Update(InputAt(0.001)).q, first);
}

TEST(PolicyControllerTest, FactorsOnGainsAct) {
  Recorder recorder;
  GainOptions gains;
  gains.stiffness_scale = 0.5;
  gains.damping_scale = 2.0;
  PolicyController controller(A1(), Fitted(written::ContractText(A1()), recorder.Source()), 0.0, gains);
  EXPECT_EQ(controller.Update(InputAt(0.0)).stiffness, VectorX::Constant(12, 50.0));
  EXPECT_EQ(controller.Update(InputAt(0.0)).damping, VectorX::Constant(12, 4.0));
}

TEST(PolicyControllerTest, AnActionOfAnotherSizeIsRefused) {
  PolicySource source;
  source.name = "short";
  source.function = [](const Eigen::VectorXf&) { return Eigen::VectorXf::Zero(3).eval(); };
  PolicyController controller(A1(), Fitted(written::ContractText(A1()), source), 0.0, {});
  EXPECT_THROW(controller.Update(InputAt(0.1)), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
