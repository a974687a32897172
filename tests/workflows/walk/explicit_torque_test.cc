// SPDX-License-Identifier: BSD-3-Clause
// Motors that are told a torque at the start of a step, as on hardware: the gains have to know the step.
#include <gtest/gtest.h>

#include "kinematics/model/load_robot.h"
#include "workflows/walk/walk.h"

namespace gaitwright {
namespace {

struct ExplicitCase {
  const char* robot;
  const char* controller;
  double step_s;
};

class ExplicitTorque : public testing::TestWithParam<ExplicitCase> {};

PlannedWalk ShortWalk(const RobotModel& model) {
  WalkRequest request;
  request.command.distance_m = 0.5;
  return *PlanWalk(model, request);
}

TEST_P(ExplicitTorque, WalksToTheEnd) {
  const RobotModel model = *LoadNamedRobot(GetParam().robot);
  PlayRequest request;
  request.controller = GetParam().controller;
  request.play.world.actuation = "torque";
  request.play.world.step_s = GetParam().step_s;
  const Result<PlayedWalk> played = PlayWalk(model, ShortWalk(model).motion.plan, request);
  ASSERT_TRUE(played) << played.failure().message;
  EXPECT_TRUE(played->report.pass) << played->report.reason;
}

// Replaying a trot without feedback needs more damping than a light leg allows at 1 ms; at a quarter of it, it has it.
INSTANTIATE_TEST_SUITE_P(Robots, ExplicitTorque,
                         testing::Values(ExplicitCase{"a1", "stabilised", 1e-3},
                                         ExplicitCase{"nao", "stabilised", 1e-3}, ExplicitCase{"nao", "joint-pd", 1e-3},
                                         ExplicitCase{"a1", "joint-pd", 2.5e-4}),
                         [](const auto& tested) {
                           return std::string(tested.param.robot) +
                                  (tested.param.controller[0] == 's' ? "_stabilised" : "_joint_pd");
                         });

TEST(GainsOfARequest, ReachBothControllers) {
  const RobotModel model = *LoadNamedRobot("a1");
  const MotionPlan plan = ShortWalk(model).motion.plan;
  for (const char* name : {"joint-pd", "stabilised"}) {
    ControlInput input;
    input.q = plan.whole_body.q.front();
    input.v = plan.whole_body.v.front();
    input.wrenches = plan.whole_body.wrenches.front();
    input.contact = AllFeet(static_cast<int>(model.feet.size()));
    PlayRequest request;
    request.controller = name;
    const VectorX usual = MakeController(model, plan, request)->Update(input).damping;
    OptionFields fields = request.Fields();
    SetOption(fields, "gains.stance_damping", "0.35");
    const VectorX halved = MakeController(model, plan, request)->Update(input).damping;
    EXPECT_LT((halved - 0.5 * usual).norm(), 1e-9 * usual.norm()) << name;
    request.play.world.actuation = "torque";
    EXPECT_LT(MakeController(model, plan, request)->Update(input).damping.maxCoeff(), 0.5 * halved.maxCoeff()) << name;
    SetOption(fields, "gains.explicit_step_s", "1e-5");
    EXPECT_GT(MakeController(model, plan, request)->Update(input).damping.minCoeff(), 0.99 * halved.minCoeff()) << name;
  }
}

}  // namespace
}  // namespace gaitwright
