// SPDX-License-Identifier: BSD-3-Clause
#include "examples/adaptive_pd.h"

#include <gtest/gtest.h>

#include <Eigen/QR>

#include "examples/carry_payload.h"
#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/model/load_robot.h"

namespace gaitwright::examples {
namespace {

/// Stands for 1 s, each foot with its share of the weight.
MotionPlan Standing(const RobotModel& model) {
  std::vector<ContactWrench> wrenches(model.feet.size());
  for (ContactWrench& wrench : wrenches) wrench.force_W.z() = model.weight_n() / static_cast<double>(model.feet.size());
  MotionPlan plan;
  plan.whole_body.step_s = 0.5;
  for (int k = 0; k < 3; ++k) {
    plan.whole_body.q.push_back(StandingConfiguration(model));
    plan.whole_body.v.push_back(VectorX::Zero(model.nv()));
    plan.whole_body.a.push_back(VectorX::Zero(model.nv()));
    plan.whole_body.tau.push_back(VectorX::Constant(model.num_dofs(), 2.0));
    plan.whole_body.wrenches.push_back(wrenches);
  }
  return plan;
}

/// Rates of the joints that raise the base by 1 m/s over feet that rest: J (v_base, rates) = 0.
VectorX RisingJoints(const RobotModel& model, const VectorX& q) {
  DynamicsScratch scratch(model);
  ForwardKinematics(model, q, scratch);
  const auto rows = 3 * static_cast<Eigen::Index>(model.feet.size());
  MatrixX J(rows, model.nv()), J_foot(6, model.nv());
  for (std::size_t f = 0; f < model.feet.size(); ++f) {
    const int body = model.feet[f].body;
    const auto b = static_cast<std::size_t>(body);
    const Vector3 p_WF = ContactFrame(model, scratch, static_cast<int>(f)).translation();
    PointJacobian(model, scratch, body, scratch.R_WB[b].transpose() * (p_WF - scratch.p_WB[b]), J_foot);
    J.middleRows(3 * static_cast<Eigen::Index>(f), 3) = J_foot.topRows(3);
  }
  return J.rightCols(model.num_dofs()).colPivHouseholderQr().solve(-J.col(2));
}

// d'Alembert: what the joints do is what lifts a kilogram.
TEST(AdaptivePdExample, TheTorquesOfAKilogramLiftAKilogram) {
  const RobotModel model = *LoadNamedRobot("a1");
  const MotionPlan plan = Standing(model);
  const VectorX q = plan.whole_body.q.front(), rising = RisingJoints(model, q);
  DynamicsScratch scratch(model);
  const VectorX Y = TorquePerKilogram(model, q, plan.whole_body.wrenches.front(), scratch);
  EXPECT_GT(rising.norm(), 1.0);
  EXPECT_NEAR(Y.dot(rising), kGravity, 1e-9);
}

TEST(AdaptivePdExample, AKilogramThatIsMissingGrowsAtTheRateAndIsFedForward) {
  const RobotModel model = *LoadNamedRobot("a1");
  const MotionPlan plan = Standing(model);
  AdaptivePd controller(model, plan, 2.0);
  ControlInput input;
  input.step_s = 0.001;
  input.q = plan.whole_body.q.front();
  input.v = VectorX::Zero(model.nv());
  const JointCommand still = controller.Update(input);
  EXPECT_EQ(controller.payloads_kg().back(), 0.0) << "nothing sags, nothing is learnt";
  EXPECT_LT((still.tau_ff - plan.whole_body.tau.front()).norm(), 1e-12);

  DynamicsScratch scratch(model);
  const VectorX Y = TorquePerKilogram(model, input.q, plan.whole_body.wrenches.front(), scratch);
  input.v.tail(model.num_dofs()) = -Y.cwiseQuotient(still.damping);  // as the joints yield to a kilogram
  const JointCommand sagging = controller.Update(input);
  EXPECT_NEAR(controller.payloads_kg().back(), 0.002, 1e-12);
  EXPECT_LT((sagging.tau_ff - plan.whole_body.tau.front() - 0.002 * Y).norm(), 1e-12);

  input.v *= -2.0;
  controller.Update(input);
  EXPECT_EQ(controller.payloads_kg().back(), 0.0) << "a payload is never negative";
  controller.Reset();
  EXPECT_TRUE(controller.payloads_kg().empty());
}

/// The mean error of the joints [rad].
double ErrorOf(const CarriedPayload& run) { return run.report.At("tracking_joint_rms_rad").value.value(); }

TEST(AdaptivePdExample, FindsThePayloadAndNoOther) {
  const CarriedPayload plain = CarryPayload("a1", 4.0, 0.0);
  EXPECT_EQ(plain.estimates_kg.back(), 0.0);
  for (const double payload_kg : {4.0, 1.5, 0.0}) {
    const CarriedPayload adaptive = CarryPayload("a1", payload_kg, 3.0);
    EXPECT_TRUE(adaptive.report.pass) << adaptive.report.reason;
    EXPECT_NEAR(adaptive.estimates_kg.back(), payload_kg, 0.05 * payload_kg + 0.02);
    EXPECT_LT(ErrorOf(adaptive), 0.3 * ErrorOf(plain)) << payload_kg;
  }
}

TEST(AdaptivePdExample, WhatCannotBeIsNamed) {
  EXPECT_THROW(CarryPayload("a1", -1.0, 3.0), InvalidArgument);
  EXPECT_THROW(CarryPayload("a1", 1.0, -3.0), InvalidArgument);
  EXPECT_THROW(CarryPayload("a2", 1.0, 3.0), InvalidArgument);
  const RobotModel model = *LoadNamedRobot("a1");
  MotionPlan flying = Standing(model);
  for (auto& wrenches : flying.whole_body.wrenches) wrenches.assign(model.feet.size(), {});
  EXPECT_THROW(AdaptivePd(model, flying, 1.0), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright::examples
