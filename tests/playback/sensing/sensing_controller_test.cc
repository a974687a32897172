// SPDX-License-Identifier: BSD-3-Clause
#include "playback/sensing/sensing_controller.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kinematics/base/result.h"
#include "playback/bullet/bullet_world.h"
#include "playback/control/joint_pd.h"
#include "playback/control/stabilised.h"
#include "playback/log/log_json.h"
#include "playback/play/play.h"
#include "playback/score/stability_report.h"
#include "tests/playback/one_joint.h"
#include "tests/playback/short_walk.h"
#include "tests/playback/standing_plan.h"

namespace gaitwright {
namespace {

/// Stores its inputs, and commands the number of the step.
class Witness : public Controller {
 public:
  explicit Witness(std::vector<ControlInput>& inputs) : inputs_(inputs) {}

  JointCommand Update(const ControlInput& input) override {
    inputs_.push_back(input);
    const VectorX number = VectorX::Constant(1, static_cast<double>(count_++));
    return {number, number, number, number, number};
  }
  void Reset() override { count_ = 0; }
  std::string Name() const override { return "witness"; }

 private:
  std::vector<ControlInput>& inputs_;
  int count_ = 0;
};

ControlInput InputOf(const VectorX& q, const VectorX& v, std::size_t feet) {
  ControlInput input;
  input.q = q;
  input.v = v;
  input.wrenches.assign(feet, {Vector3(1.0, 2.0, 30.0), Vector3::Ones()});
  input.contact = AllFeet(static_cast<int>(feet));
  return input;
}

SensingOptions With(const std::string& state, const std::string& kind, double delay_s) {
  SensingOptions options;
  options.state = state;
  options.command_delay_s = delay_s;
  options.sensors = SensorsOfKind(kind);
  return options;
}

TEST(SensingController, IsNotThereWhereThereIsNothingBetween) {
  const RobotModel model = standing::Load("a1");
  const MotionPlan plan = standing::Plan(model, 0.1);
  std::vector<ControlInput> inputs;
  auto witness = std::make_unique<Witness>(inputs);
  const Controller* bare = witness.get();
  EXPECT_EQ(BehindSensors(model, plan, std::move(witness), {}).get(), bare);
  const auto late = BehindSensors(model, plan, std::make_unique<Witness>(inputs), With("true", "ideal", 0.001));
  EXPECT_EQ(late->Name(), "witness");
  EXPECT_EQ(late->Estimate(), nullptr);
}

TEST(SensingController, CommandsComeLateByWholeSteps) {
  const RobotModel model = standing::Load("a1");
  const MotionPlan plan = standing::Plan(model, 0.1);
  const ControlInput input = InputOf(StandingConfiguration(model), VectorX::Zero(model.nv()), 4);
  for (const double delay_s : {0.001, 0.004, 0.0126}) {
    std::vector<ControlInput> inputs;
    const auto late = BehindSensors(model, plan, std::make_unique<Witness>(inputs), With("true", "ideal", delay_s));
    for (int playback = 0; playback < 2; ++playback) {
      late->Reset();
      for (int k = 0; k < 40; ++k) {
        const int due = std::max(0, k - static_cast<int>(std::lround(delay_s / 0.001)));
        EXPECT_EQ(late->Update(input).tau_ff[0], due);
      }
    }
    EXPECT_EQ(inputs.back().q, input.q);
    EXPECT_EQ(inputs.back().wrenches, input.wrenches);
  }
}

TEST(SensingController, TellsWhatIsMeasured) {
  const RobotModel model = standing::Load("a1");
  const MotionPlan plan = standing::Plan(model, 0.1);
  std::vector<ControlInput> inputs;
  const auto measured = BehindSensors(model, plan, std::make_unique<Witness>(inputs), With("measured", "ideal", 0.0));
  VectorX q = StandingConfiguration(model), v = VectorX::Constant(model.nv(), 0.3);
  for (int k = 0; k < 5; ++k) {
    q.tail(12) += 0.001 * v.tail(12);
    measured->Update(InputOf(q, v, 4));
  }
  EXPECT_EQ(inputs.back().q.head<7>(), q.head<7>());
  EXPECT_EQ(inputs.back().v.head<6>(), v.head<6>());
  EXPECT_NEAR((inputs.back().q - q).norm(), 0.0, 1e-12);
  EXPECT_NEAR((inputs.back().v - v).norm(), 0.0, 1e-9);
  EXPECT_EQ(inputs.back().contact, AllFeet(4));
  EXPECT_EQ(inputs.back().wrenches[2].force_W, Vector3(0.0, 0.0, 30.0)) << "pads feel the vertical force";
  EXPECT_EQ(measured->Estimate(), nullptr);
}

/// A hinge in free fall that should be held at 0.5 rad, and the inputs of its controller.
struct Held {
  explicit Held(const SensingOptions& options) {
    VectorX q = VectorX::Zero(8);
    q[2] = 1000.0;
    q[6] = 1.0;
    plan.terrain = FlatTerrain();
    plan.whole_body.step_s = 0.005;
    for (int k = 0; k < 2; ++k) {
      q[7] = kTarget;
      plan.whole_body.q.push_back(q);
      plan.whole_body.v.emplace_back(VectorX::Zero(7));
      plan.whole_body.a.emplace_back(VectorX::Zero(7));
      plan.whole_body.tau.emplace_back(VectorX::Zero(1));
    }
    WorldOptions world;
    world.actuation = options.drive_loop == "sensed" ? "torque" : "implicit-pd";
    BulletWorld hinge(model, plan.terrain, q, world);
    GainOptions soft;
    soft.free_frequency_rad_s = 20.0;
    const auto controller = BehindSensors(model, plan, std::make_unique<JointPd>(model, plan, soft), options);
    controller->Reset();
    ControlInput input;
    for (int k = 0; k < 3000; ++k) {
      input.q = hinge.q();
      input.v = hinge.v();
      hinge.Step(controller->Update(input));
    }
    at = hinge.q()[7];
    torque = hinge.tau()[0];
  }

  static constexpr double kTarget = 0.5;
  RobotModel model = one_joint::Make(JointType::kRevolute);
  MotionPlan plan;
  double at = 0.0, torque = 0.0;
};

TEST(SensingController, AZeroThatIsOffMovesWhatADriveHolds) {
  SensingOptions options = With("measured", "ideal", 0.0);
  EXPECT_NEAR(Held(options).at, Held::kTarget, 1e-6);
  options.sensors.encoder_bias_rad = 0.05;
  Encoders same(1, options.sensors, 0.001);
  const double bias = same.bias()[0];
  ASSERT_GT(std::abs(bias), 1e-3);
  EXPECT_NEAR(Held(options).at, Held::kTarget - bias, 1e-6) << "the drive's encoder reads the target";
  options.drive_loop = "sensed";
  EXPECT_NEAR(Held(options).at, Held::kTarget - bias, 1e-6) << "and so does the controller's";
  options = With("true", "ideal", 0.001);
  options.sensors.encoder_bias_rad = 0.05;
  EXPECT_NEAR(Held(options).at, Held::kTarget, 1e-6) << "with the true state no sensor counts";
}

TEST(SensingController, TheLoopIsTheDrivesOwnUnlessItIsAskedToBeTheControllers) {
  const RobotModel model = one_joint::Make(JointType::kRevolute);
  MotionPlan plan = Held(With("measured", "ideal", 0.0)).plan;
  const auto update = [&](const char* loop) {
    SensingOptions options = With("measured", "ideal", 0.0);
    options.drive_loop = loop;
    const auto controller = BehindSensors(model, plan, std::make_unique<JointPd>(model, plan), options);
    ControlInput input;
    input.q = plan.whole_body.q.front();
    input.v = VectorX::Zero(7);
    input.q[7] += 0.1;
    return controller->Update(input);
  };
  const JointCommand own = update("own"), sensed = update("sensed");
  EXPECT_GT(own.stiffness[0], 0.0);
  EXPECT_EQ(own.tau_ff[0], 0.0);
  EXPECT_EQ(sensed.stiffness[0], 0.0);
  EXPECT_EQ(sensed.damping[0], 0.0);
  EXPECT_NEAR(sensed.tau_ff[0], -0.1 * own.stiffness[0], 1e-9);
}

TEST(SensingOptions, SayHowOldSpeedsAreInASensedLoop) {
  SensingOptions options = With("true", "hobby", 0.004);
  EXPECT_EQ(options.LoopDelay(), 0.004);
  options.state = "measured";
  options.sensors.encoder_delay_s = 0.002;
  options.sensors.encoder_rate_hz = 500.0;
  EXPECT_NEAR(options.LoopDelay(), 0.004 + 0.002 + 0.002 + 2.0 / (2.0 * 3.14159265358979 * 50.0), 1e-12);
}

TEST(SensingController, RefusesOptionsOutOfRange) {
  const RobotModel model = standing::Load("a1");
  const MotionPlan plan = standing::Plan(model, 0.1);
  std::vector<ControlInput> inputs;
  const auto refused = [&](const SensingOptions& options, const MotionPlan& of) {
    EXPECT_THROW(SensingController(model, of, std::make_unique<Witness>(inputs), options), InvalidArgument);
  };
  refused(With("true", "ideal", 0.2), plan);
  refused(With("guessed", "ideal", 0.0), plan);
  SensingOptions loop = With("measured", "ideal", 0.0);
  loop.drive_loop = "mine";
  refused(loop, plan);
  refused(With("estimated", "ideal", 0.0), MotionPlan{});
}

PlaybackLog Played(const RobotModel& model, const MotionPlan& plan, const SensingOptions& options) {
  const auto controller = BehindSensors(model, plan, MakeStabilised(model, plan, {}), options);
  const PlayOptions usual;
  return Play(model, plan, *controller, usual).value();
}

TEST(SensingController, WithPerfectSensorsARobotIsWhereItThinksItIs) {
  for (const char* name : {"a1", "nao"}) {
    const RobotModel model = standing::Load(name);
    const MotionPlan plan = standing::Plan(model, 0.5);
    const PlaybackLog log = Played(model, plan, With("estimated", "ideal", 0.0));
    for (const LogSample& sample : log.samples) {
      ASSERT_TRUE(sample.estimate.has_value());
      EXPECT_LT((sample.estimate->p_WB - sample.q.head<3>()).norm(), 1e-3);
      EXPECT_LT((sample.estimate->v_WB - sample.v.head<3>()).norm(), 1e-3);
      EXPECT_LT((sample.estimate->w_WB - sample.v.segment<3>(3)).norm(), 1e-3);
      EXPECT_LT((sample.estimate->R_WB.coeffs() - sample.q.segment<4>(3)).norm(), 1e-3);
    }
    EXPECT_EQ(log.controller, "stabilised");
    EXPECT_FALSE(Played(model, plan, With("measured", "ideal", 0.0)).samples.front().estimate.has_value());
  }
}

TEST(SensingController, TheSameSeedGivesTheSameBytesAndAnotherOthers) {
  const RobotModel model = standing::Load("a1");
  const MotionPlan plan = standing::Plan(model, 0.3);
  SensingOptions options = With("estimated", "hobby", 0.004);
  const std::string first = LogToJson(Played(model, plan, options));
  EXPECT_EQ(LogToJson(Played(model, plan, options)), first);
  options.sensors.seed = 1;
  EXPECT_NE(LogToJson(Played(model, plan, options)), first);
}

TEST(SensingController, ATrotStaysUpOnHobbySensorsWithLateCommands) {
  const RobotModel model = standing::Load("a1");
  const MotionPlan plan = ShortWalk(model, "trot", 12, 0.04);
  for (const int seed : {0, 1}) {
    SensingOptions options = With("estimated", "hobby", 0.004);
    options.sensors.seed = seed;
    const PlaybackLog log = Played(model, plan, options);
    const StabilityReport report = Score(model, plan, log);
    EXPECT_EQ(report.At("fell").value.value(), 0.0) << report.reason;
    EXPECT_LT(report.At("goal_error_m").value.value(), 0.1);
    EXPECT_LT(report.At("estimate_drift_m").value.value(), 0.05);
    EXPECT_LT(report.At("estimate_height_m").value.value(), 0.03);
    EXPECT_LT(report.At("estimate_tilt_rad").value.value(), 0.05);
    EXPECT_LT(report.At("estimate_velocity_m_s").value.value(), 0.04);
    EXPECT_GT(report.At("estimate_velocity_m_s").value.value(), 0.001) << "sensors are not perfect";
  }
}

}  // namespace
}  // namespace gaitwright
