// SPDX-License-Identifier: BSD-3-Clause
#include "examples/own_controller.h"

#include <gtest/gtest.h>

#include "kinematics/model/load_robot.h"

namespace gaitwright::examples {
namespace {

TEST(OwnControllerExample, WalksWithBothRobots) {
  for (const char* robot : {"a1", "nao"}) {
    const StabilityReport report = WalkWithOwnController(robot, 0.2);
    EXPECT_TRUE(report.pass) << robot << ": " << report.reason;
  }
}

TEST(OwnControllerExample, FadesTheFeedForwardInAndHoldsThePlan) {
  const RobotModel model = *LoadNamedRobot("a1");
  const auto n = static_cast<Eigen::Index>(model.num_dofs());
  MotionPlan plan;
  plan.whole_body.start_s = 1.0;
  plan.whole_body.step_s = 0.5;
  for (int k = 0; k < 3; ++k) {
    plan.whole_body.q.push_back(StandingConfiguration(model));
    plan.whole_body.v.push_back(VectorX::Zero(model.nv()));
    plan.whole_body.a.push_back(VectorX::Zero(model.nv()));
    plan.whole_body.tau.push_back(VectorX::Constant(n, 8.0));
    plan.whole_body.wrenches.push_back(std::vector<ContactWrench>(model.feet.size()));
  }
  FadingIn controller(model, plan, 0.4);
  ControlInput input;
  input.time_s = 1.1;
  EXPECT_NEAR(controller.Update(input).tau_ff[3], 2.0, 1e-12);
  EXPECT_LT((controller.Update(input).q - model.standing_joints).norm(), 1e-12);
  input.time_s = 1.9;
  EXPECT_EQ(controller.Update(input).tau_ff[3], 8.0);
  EXPECT_THROW(FadingIn(model, plan, 0.0), InvalidArgument);
}

TEST(OwnControllerExample, AnUnknownRobotIsNamed) { EXPECT_THROW(WalkWithOwnController("a2", 0.2), InvalidArgument); }

}  // namespace
}  // namespace gaitwright::examples
