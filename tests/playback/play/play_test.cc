// SPDX-License-Identifier: BSD-3-Clause
#include "playback/play/play.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <thread>

#include "kinematics/base/result.h"
#include "playback/control/joint_pd.h"
#include "playback/control/stabilised.h"
#include "playback/log/log_json.h"
#include "playback/play/make_world.h"
#include "tests/playback/standing_plan.h"

namespace gaitwright {
namespace {

/// Gives no torque to any joint.
class Limp : public Controller {
 public:
  explicit Limp(int n) : zero_(VectorX::Zero(n)) {}
  JointCommand Update(const ControlInput&) override { return {zero_, zero_, zero_, zero_, zero_}; }
  std::string Name() const override { return "limp"; }

 private:
  VectorX zero_;
};

/// Stores its inputs.
class Listener : public JointPd {
 public:
  using JointPd::JointPd;
  JointCommand Update(const ControlInput& input) override {
    inputs.push_back(input);
    return JointPd::Update(input);
  }
  void Reset() override { ++resets; }

  std::vector<ControlInput> inputs;
  int resets = 0;
};

class PlayTest : public ::testing::TestWithParam<const char*> {
 protected:
  PlaybackLog Stand(const PlayOptions& options) const {
    JointPd controller(model_, plan_);
    return Play(model_, plan_, controller, options).value();
  }

  const RobotModel model_ = standing::Load(GetParam());
  const MotionPlan plan_ = standing::Plan(model_, 1.0);
};

TEST_P(PlayTest, LogsAStand) {
  const PlaybackLog log = Stand({});
  EXPECT_EQ(log.robot, model_.name);
  EXPECT_EQ(log.plan_hash, MotionHash(plan_));
  EXPECT_EQ(log.controller, "joint-pd");
  ASSERT_EQ(log.samples.size(), 260U);
  EXPECT_NEAR(log.samples.front().time_s, 0.005, 1e-12);
  EXPECT_NEAR(log.samples.back().time_s, 1.3, 1e-12);
  double force = 0.0;
  for (const ContactWrench& wrench : log.samples.back().wrenches) force += wrench.force_W.z();
  EXPECT_NEAR(force, model_.weight_n(), 1e-3 * model_.weight_n());
  EXPECT_EQ(log.samples.back().contact, AllFeet(static_cast<int>(model_.feet.size())));
  ASSERT_EQ(log.stances.size(), model_.feet.size());
  for (const StanceRecord& stance : log.stances) {
    EXPECT_EQ(stance.touchdown_s, 0.0);
    EXPECT_NEAR(stance.liftoff_s, 1.3, 1e-12);
    EXPECT_LT(stance.slip_m, 1e-5);
    EXPECT_LE(stance.friction_use_max, 1.0 + 1e-9);
  }
  EXPECT_EQ(log.saturated_s.norm(), 0.0);
}

TEST_P(PlayTest, StancesAfterTheLastSampleAreWhole) {
  PlayOptions options;
  options.push_force_W = Vector3(0.0, 0.0, 2.0 * model_.weight_n());  // off the ground and down again
  options.push_for_s = 0.1;
  options.push_at_s = 0.8;
  options.hold_s = 0.9;
  options.log_rate_hz = 1.0;
  options.fall_height_lowest = 0.0;
  const PlaybackLog log = Stand(options);
  ASSERT_EQ(log.samples.size(), 1U);
  int later = 0;
  for (const StanceRecord& stance : log.stances) {
    EXPECT_LE(stance.touchdown_s, stance.liftoff_s);
    EXPECT_LE(stance.liftoff_s, 1.9 + 1e-9);
    later += stance.touchdown_s > log.samples.back().time_s ? 1 : 0;
  }
  EXPECT_GT(later, 0);
}

TEST_P(PlayTest, RefusesPlansThatLackColumns) {
  const auto without = [&](auto change) {
    MotionPlan plan = plan_;
    change(plan.whole_body);
    return plan;
  };
  const MotionPlan no_torques = without([](auto& w) { w.tau.clear(); });
  const MotionPlan no_forces = without([](auto& w) { w.wrenches.clear(); });
  const MotionPlan short_v = without([](auto& w) { w.v.pop_back(); });
  EXPECT_THROW(JointPd(model_, no_torques), InvalidArgument);
  EXPECT_THROW((void)MakeStabilised(model_, no_forces, {}), InvalidArgument);
  MotionPlan no_schedule = plan_;
  no_schedule.schedule.phases.clear();
  EXPECT_THROW((void)MakeStabilised(model_, no_schedule, {}), InvalidArgument);
  JointPd controller(model_, plan_);
  JointPd without_forces(model_, no_forces);
  EXPECT_TRUE(Play(model_, no_forces, without_forces).ok());
  EXPECT_TRUE(Play(model_, no_torques, controller).ok());
  const Result<PlaybackLog> refused = Play(model_, short_v, controller);
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.failure().message.find("201 rows of q, but 200 of v"), std::string::npos)
      << refused.failure().message;
}

TEST_P(PlayTest, RefusesBumpsWithoutEnd) {
  MotionPlan plan = plan_;
  plan.whole_body.q.back()[0] = 1e9;
  PlayOptions options;
  options.world.ground_bumps_m = 0.01;
  JointPd controller(model_, plan_);
  try {
    (void)Play(model_, plan, controller, options);
    FAIL();
  } catch (const InvalidArgument& error) {
    EXPECT_NE(std::string(error.what()).find("ground_bumps_m: bumpy ground of 1e+09 m by 4 m"), std::string::npos)
        << error.what();
  }
}

TEST_P(PlayTest, RepeatsBitForBit) {
  PlayOptions options;
  options.push_force_W = Vector3(0.0, 10.0, 0.0);
  options.push_at_s = 0.2;
  options.world.ground_bumps_m = 0.005;
  EXPECT_EQ(LogToJson(Stand(options)), LogToJson(Stand(options)));
}

TEST_P(PlayTest, RepeatsBitForBitInThreads) {
  const std::string alone = LogToJson(Stand({}));
  std::vector<std::string> logs(3);
  std::vector<std::thread> threads;
  for (std::string& log : logs) threads.emplace_back([&] { log = LogToJson(Stand({})); });
  for (std::thread& thread : threads) thread.join();
  for (const std::string& log : logs) EXPECT_EQ(log, alone);
}

TEST_P(PlayTest, AsksTheControllerOnThePlansClock) {
  Listener controller(model_, plan_);
  const PlaybackLog log = Play(model_, plan_, controller).value();
  EXPECT_EQ(controller.resets, 1);
  ASSERT_EQ(controller.inputs.size(), 1500U);
  EXPECT_EQ(controller.inputs[199].time_s, 0.0) << "the clock stands while the robot settles";
  EXPECT_EQ(controller.inputs[200].time_s, 0.0);
  EXPECT_NEAR(controller.inputs.back().time_s, 1.299, 1e-12);
  EXPECT_EQ(controller.inputs.back().contact, AllFeet(static_cast<int>(model_.feet.size())));
  EXPECT_GT(controller.inputs.back().wrenches[0].force_W.z(), 0.0);
}

TEST_P(PlayTest, AFirstPostureInTheGroundIsLoggedWithItsDepthInEachEngine) {
  EXPECT_EQ(Stand({}).start_penetration, std::nullopt);
  MotionPlan sunk = plan_;
  for (VectorX& q : sunk.whole_body.q) q.z() -= 0.006;
  for (const std::string& engine : EngineNames()) {
    PlayOptions options;
    options.world.engine = engine;
    JointPd controller(model_, sunk);
    const PlaybackLog log = Play(model_, sunk, controller, options).value();
    ASSERT_TRUE(log.start_penetration) << engine;
    EXPECT_NEAR(log.start_penetration->depth_m, 0.006, 1e-4) << engine;
    const auto is_it = [&](const Foot& foot) { return foot.link == log.start_penetration->link; };
    EXPECT_TRUE(std::any_of(model_.feet.begin(), model_.feet.end(), is_it)) << log.start_penetration->link;
    EXPECT_EQ(log.start_penetration->solid, sunk.terrain.patches.front().name);
    EXPECT_EQ(LogFromJson(LogToJson(log), "log").value().start_penetration, log.start_penetration);
  }
}

TEST_P(PlayTest, APushMovesTheRobot) {
  PlayOptions options;
  options.push_force_W = Vector3(0.0, 0.1 * model_.weight_n(), 0.0);
  options.push_at_s = 0.5;
  const PlaybackLog log = Stand(options);
  EXPECT_LT(std::abs(log.samples[98].v[1]), 1e-3);
  EXPECT_GT(log.samples[110].v[1], 1e-3);
}

TEST_P(PlayTest, EndsSoonAfterAFall) {
  Limp controller(model_.num_dofs());
  MotionPlan longer = standing::Plan(model_, 20.0);
  PlayOptions options;
  options.settle_s = 0.0;
  const PlaybackLog log = Play(model_, longer, controller, options).value();
  EXPECT_LT(log.samples.back().time_s, 10.0);
  EXPECT_FALSE(log.body_contacts.empty());
  EXPECT_TRUE(log.samples.back().q.allFinite());
}

TEST_P(PlayTest, StartsOnASlopeThatItDoesNotKnow) {
  PlayOptions options;
  options.world.ground_slope_deg = 2.0;
  const PlaybackLog log = Stand(options);
  EXPECT_TRUE(log.body_contacts.empty());
  EXPECT_EQ(log.stances.size(), model_.feet.size());
  const VectorX& q = log.samples.back().q;
  const Matrix3 R = Quaternion(q[6], q[3], q[4], q[5]).toRotationMatrix();
  EXPECT_NEAR(-R(2, 0), -std::sin(2.0 * 3.14159265358979 / 180.0), 0.02);
}

TEST_P(PlayTest, WeldsWhatNeverMovesWhenAsked) {
  PlayOptions options;
  options.lock_unmoved = true;
  const PlaybackLog log = Stand(options);
  EXPECT_EQ((log.samples.back().q.tail(model_.num_dofs()) - model_.standing_joints).norm(), 0.0);
  EXPECT_EQ(log.samples.back().tau.norm(), 0.0);
}

TEST_P(PlayTest, WritesItsOptionsDown) {
  PlayOptions options;
  options.world.mass_scale = 1.1;
  const PlaybackLog log = Stand(options);
  EXPECT_NE(
      std::find(log.options.begin(), log.options.end(), std::pair<std::string, std::string>("play.mass_scale", "1.1")),
      log.options.end());
  EXPECT_NEAR(log.total_mass_kg, 1.1 * model_.total_mass_kg, 1e-12);
}

TEST_P(PlayTest, RefusesPlansOfOthersAndBadRates) {
  JointPd controller(model_, plan_);
  MotionPlan other = plan_;
  other.robot_hash = "0000000000000000";
  other.robot = "somebody";
  const auto refused = Play(model_, other, controller);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.failure().code, FailureCode::kPlanOfOtherRobot);
  EXPECT_NE(refused.failure().message.find("somebody"), std::string::npos);
  other.whole_body = {};
  other.robot_hash = plan_.robot_hash;
  EXPECT_EQ(Play(model_, other, controller).failure().code, FailureCode::kPlanWithoutMotion);
  PlayOptions options;
  options.log_rate_hz = 300.0;
  EXPECT_THROW((void)Play(model_, plan_, controller, options), InvalidArgument);
  options.world.step_s = 0.003;
  options.log_rate_hz = 166.667;  // the value that a refusal names
  EXPECT_EQ(ReasonNotPlayed(model_, plan_, options), std::nullopt);
  options = {};
  options.world.step_s = -1.0;
  EXPECT_THROW((void)Play(model_, plan_, controller, options), InvalidArgument);
}

/// Folds the legs vertically to about half of the standing height over the first half of the plan.
MotionPlan Sinking(const RobotModel& a1, double duration_s) {
  MotionPlan plan = standing::Plan(a1, duration_s);
  const double stands = a1.standing_joints[a1.DofIndex("FL_thigh_joint")], folded = 1.25;
  for (std::size_t k = 0; k < plan.whole_body.q.size(); ++k) {
    const double u = std::min(1.0, 2.0 * static_cast<double>(k) / static_cast<double>(plan.whole_body.q.size()));
    const double thigh = stands + u * (folded - stands);
    for (const char* leg : {"FL", "FR", "RL", "RR"}) {
      plan.whole_body.q[k][7 + a1.DofIndex(std::string(leg) + "_thigh_joint")] = thigh;
      plan.whole_body.q[k][7 + a1.DofIndex(std::string(leg) + "_calf_joint")] = -2.0 * thigh;
    }
    plan.whole_body.q[k][2] += 0.4 * (std::cos(thigh) - std::cos(stands));
  }
  return plan;
}

TEST(Play, EndsSoonAfterTheBaseHasSunk) {
  const RobotModel a1 = standing::Load("a1");
  const MotionPlan upright = standing::Plan(a1, 4.0), sinking = Sinking(a1, 4.0);
  PlayOptions options;
  const auto log = [&](const MotionPlan& plan, double lowest) {
    options.fall_height_lowest = lowest;
    JointPd sinks(a1, sinking);
    return Play(a1, plan, sinks, options).value();
  };
  const PlaybackLog sunk = log(upright, 0.75);
  EXPECT_TRUE(sunk.body_contacts.empty()) << "neither a touch";
  const double height = upright.whole_body.q.front()[2];
  const LogSample& at_fall = sunk.samples.at(sunk.samples.size() - 61);  // 0.3 s before the end
  EXPECT_NEAR(at_fall.q[2], 0.75 * height, 0.01 * height);
  EXPECT_NEAR(Quaternion(at_fall.q[6], at_fall.q[3], at_fall.q[4], at_fall.q[5]).w(), 1.0, 1e-3) << "nor a tilt";
  EXPECT_LT(sunk.samples.back().time_s, 2.0);
  const double whole_s = 4.0 + options.hold_s;
  EXPECT_NEAR(log(upright, 0.4).samples.back().time_s, whole_s, 1e-9) << "half the height is no fall by default";
  EXPECT_NEAR(log(upright, 0.0).samples.back().time_s, whole_s, 1e-9) << "0 never ends it";
  EXPECT_NEAR(log(sinking, 0.75).samples.back().time_s, whole_s, 1e-9) << "the plan itself is low";
  options.world.ground_slope_deg = 2.0;
  EXPECT_LT(log(upright, 0.75).samples.back().time_s, 2.0) << "on a slope too";
}

INSTANTIATE_TEST_SUITE_P(Robots, PlayTest, ::testing::Values("a1", "nao"), [](const auto& i) { return i.param; });

}  // namespace
}  // namespace gaitwright
