// SPDX-License-Identifier: BSD-3-Clause
// Motors that get a torque at the start of a step, as on hardware: the gains depend on the step.
#include <gtest/gtest.h>

#include "kinematics/base/result.h"
#include "kinematics/model/joint_losses.h"
#include "kinematics/model/load_robot.h"
#include "playback/trials/trial_outcome.h"
#include "workflows/walk/walk.h"

namespace gaitwright {
namespace {

struct ExplicitCase {
  const char* robot;
  const char* controller;
  double step_s;
  double speed_m_s = 0.0;  ///< the robot's own
};

class ExplicitTorque : public testing::TestWithParam<ExplicitCase> {};

PlannedWalk ShortWalk(const RobotModel& model, double speed_m_s = 0.0) {
  WalkRequest request;
  request.command.distance_m = 0.5;
  request.command.speed_m_s = speed_m_s;
  return *PlanWalk(model, request);
}

TEST_P(ExplicitTorque, WalksToTheEnd) {
  const RobotModel model = *LoadNamedRobot(GetParam().robot);
  PlayRequest request;
  request.controller = GetParam().controller;
  request.play.world.actuation = "torque";
  request.play.world.step_s = GetParam().step_s;
  const Result<PlayedWalk> played = PlayWalk(model, ShortWalk(model, GetParam().speed_m_s).motion.plan, request);
  ASSERT_TRUE(played) << played.failure().message;
  EXPECT_TRUE(played->report.pass) << played->report.reason;
}

// Replaying a trot without feedback needs more damping than a light leg allows at 1 ms; 0.25 ms allows it. A biped
// falls without feedback unless it walks slowly.
INSTANTIATE_TEST_SUITE_P(
    Robots, ExplicitTorque,
    testing::Values(ExplicitCase{"a1", "stabilised", 1e-3}, ExplicitCase{"nao", "stabilised", 1e-3},
                    ExplicitCase{"nao", "joint-pd", 1e-3, 0.06}, ExplicitCase{"a1", "joint-pd", 2.5e-4}),
    [](const auto& tested) {
      return std::string(tested.param.robot) + (tested.param.controller[0] == 's' ? "_stabilised" : "_joint_pd");
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

TEST(LoopOfTheDrives, OnWhatIsSensedHasGainsForTheAgeOfThatAndNeedsTorques) {
  const RobotModel model = *LoadNamedRobot("a1");
  const MotionPlan plan = ShortWalk(model).motion.plan;
  ControlInput input;
  input.q = plan.whole_body.q.front();
  input.v = plan.whole_body.v.front();
  input.q.tail(12).array() += 0.1;
  const auto push = [&](double delay_s) {  // the restoring torque of a joint with a position error
    PlayRequest request;
    request.controller = "joint-pd";
    request.play.world.actuation = "torque";
    request.sensing.drive_loop = "sensed";
    request.sensing.command_delay_s = delay_s;
    const auto controller = MakeController(model, plan, request);
    return (controller->Update(input).tau_ff - plan.whole_body.tau.front()).norm();
  };
  EXPECT_GT(push(0.0), 1.0);
  EXPECT_LT(push(0.009), 0.5 * push(0.0)) << "an older loop has to be softer";
  PlayRequest implicit;
  implicit.sensing.drive_loop = "sensed";
  EXPECT_THROW(MakeController(model, plan, implicit), InvalidArgument);
}

TEST(LoopOfTheDrives, OnTheTrueStateAtOnceIsTheDrivesOwn) {
  const RobotModel model = *LoadNamedRobot("nao");
  const MotionPlan plan = ShortWalk(model).motion.plan;
  PlayRequest request;
  request.play.world.actuation = "torque";
  const PlaybackLog own = PlayWalk(model, plan, request)->log;
  request.sensing.drive_loop = "sensed";
  const PlaybackLog sensed = PlayWalk(model, plan, request)->log;
  ASSERT_EQ(own.samples.size(), sensed.samples.size());
  EXPECT_LT((own.samples.back().q - sensed.samples.back().q).lpNorm<Eigen::Infinity>(), 1e-6);
}

/// If losses are disabled, the controller does not compensate them: a robot with losses then behaves as one without.
TEST(JointLosses, ThatDoNotActAreNotMadeUpFor) {
  const RobotModel plain = *LoadNamedRobot("a1");
  RobotModel lossy = plain;
  lossy.motors.resize(plain.dof_names.size());
  for (Joint& joint : lossy.joints) joint.damping = 0.3, joint.friction = 0.4;
  for (Motor& motor : lossy.motors) motor.rotor_inertia = 0.02;
  EXPECT_EQ(WithoutLosses(lossy).joints.back().damping, 0.0);
  const MotionPlan plan = ShortWalk(plain).motion.plan;
  for (const char* controller : {"joint-pd", "stabilised"}) {
    PlayRequest request;
    request.controller = controller;
    const std::string without = SamplesHash(PlayWalk(WithoutLosses(lossy), plan, request)->log);
    EXPECT_NE(SamplesHash(PlayWalk(lossy, plan, request)->log), without) << controller;
    request.play.world.joint_losses = false;
    EXPECT_EQ(SamplesHash(PlayWalk(lossy, plan, request)->log), without) << controller;
  }
}

}  // namespace
}  // namespace gaitwright
