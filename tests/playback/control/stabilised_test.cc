// SPDX-License-Identifier: BSD-3-Clause
#include "playback/control/stabilised.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include "kinematics/base/result.h"
#include "kinematics/model/unknown_motor.h"
#include "playback/control/joint_pd.h"
#include "playback/log/log_json.h"
#include "playback/play/play.h"
#include "playback/score/stability_report.h"
#include "tests/built_paths.h"
#include "tests/playback/short_walk.h"
#include "tests/playback/standing_plan.h"

namespace gaitwright {
namespace {

/// A short walk and its playbacks.
class StabilisedTest : public ::testing::TestWithParam<const char*> {
 protected:
  bool quadruped() const { return model_.legs.size() == 4; }
  /// A lateral push for 0.1 s, in the middle of the walk.
  PlayOptions Pushed(double force_n) const {
    PlayOptions options;
    options.push_force_W = {0.0, force_n, 0.0};
    options.push_at_s = 0.5 * plan_.whole_body.end_s();
    options.hold_s = 0.6;
    return options;
  }
  PlaybackLog Stabilised(const PlayOptions& options = {}) const {
    return Play(model_, plan_, *MakeStabilised(model_, plan_, {}), options).value();
  }
  PlaybackLog Replayed(const PlayOptions& options = {}) const {
    JointPd controller(model_, plan_);
    return Play(model_, plan_, controller, options).value();
  }
  StabilityReport Judged(const PlaybackLog& log) const { return Score(model_, plan_, log); }

  const RobotModel model_ = standing::Load(GetParam());
  const MotionPlan plan_ = quadruped() ? ShortWalk(model_, "trot", 10, 0.05) : ShortWalk(model_, "", 4, 0.04);
};

/// Largest differences between two playbacks: of the base's position and quaternion, and of the joints.
struct Difference {
  double base = 0.0, joints = 0.0;
};
Difference Between(const PlaybackLog& one, const PlaybackLog& other) {
  EXPECT_EQ(one.samples.size(), other.samples.size());
  Difference most;
  for (std::size_t k = 0; k < std::min(one.samples.size(), other.samples.size()); ++k) {
    const VectorX off = one.samples[k].q - other.samples[k].q;
    most.base = std::max(most.base, off.head<7>().lpNorm<Eigen::Infinity>());
    most.joints = std::max(most.joints, off.tail(off.size() - 7).lpNorm<Eigen::Infinity>());
  }
  return most;
}

TEST_P(StabilisedTest, LeavesAnUndisturbedWalkAlmostAlone) {
  const PlaybackLog log = Stabilised();
  const StabilityReport report = Judged(log);
  EXPECT_TRUE(report.pass) << report.reason;
  EXPECT_LT(report.At("goal_error_m").value.value(), 0.005);
  EXPECT_EQ(log.controller, "stabilised");
  const Difference difference = Between(log, Replayed());
  EXPECT_LT(difference.base, 0.01);
  EXPECT_LT(difference.joints, 0.2) << "a millimetre of height is much at an almost straight knee";
  EXPECT_GT(difference.joints, 0.0);
}

/// Its motors have no known limits. A straight stance leg requested unlimited speed and torque, and the robot flew
/// away.
TEST(StabilisedFall, StaysOneOfAMachineWhereMotorsAreUnknown) {
  const RobotModel model = standing::Load("humanoid");
  const MotionPlan plan = standing::Plan(model, 1.5);
  PlayOptions options;
  options.push_at_s = 0.2;
  options.push_for_s = 0.2;
  for (const Vector3& direction : {Vector3(0.0, 1.0, 0.0), Vector3(1.0, 0.0, 0.0), Vector3(-1.0, 0.0, 0.0)}) {
    options.push_force_W = 1.5 * model.weight_n() * direction;
    const PlaybackLog log = Play(model, plan, *MakeStabilised(model, plan, {}), options).value();
    ASSERT_FALSE(Score(model, plan, log).pass);
    for (const LogSample& sample : log.samples) {
      ASSERT_LT(sample.q.z(), 1.5 * model.standing_base_height_m) << sample.time_s;
      ASSERT_LT(sample.v.head<3>().norm(), 15.0) << sample.time_s;
      for (int dof = 0; dof < model.num_dofs(); ++dof)
        ASSERT_LE(std::abs(sample.tau[dof]), BoundsOfUnknownMotor(model, dof).effort * (1.0 + 1e-9)) << sample.time_s;
    }
  }
}

TEST_P(StabilisedTest, RecoversFromAPush) {
  const PlayOptions pushed = Pushed(quadruped() ? 60.0 : 6.0);
  const PlaybackLog log = Stabilised(pushed);
  const StabilityReport report = Judged(log);
  EXPECT_TRUE(report.pass) << report.reason;
  EXPECT_GT(Between(log, Stabilised(Pushed(0.0))).base, quadruped() ? 0.05 : 0.005) << "the push is felt";
  const VectorX& q = log.samples.back().q;
  EXPECT_LT(log.samples.back().v.head<6>().norm(), 0.02) << "it stands again";
  EXPECT_LT(std::hypot(q[3], q[4]), 0.05) << "upright";
  if (quadruped()) {
    EXPECT_FALSE(Judged(Replayed(pushed)).pass) << "replay alone does not";
  }
}

TEST_P(StabilisedTest, TheSameCommandTwiceIsTheSamePlayback) {
  const PlayOptions pushed = Pushed(quadruped() ? 20.0 : 3.0);
  const std::unique_ptr<Controller> controller = MakeStabilised(model_, plan_, {});
  const std::string first = LogToJson(Play(model_, plan_, *controller, pushed).value());
  EXPECT_EQ(first, LogToJson(Play(model_, plan_, *controller, pushed).value())) << "a controller used again";
  EXPECT_EQ(first, LogToJson(Stabilised(pushed))) << "a new one";
}

INSTANTIATE_TEST_SUITE_P(Robots, StabilisedTest, ::testing::Values("a1", "nao"), [](const auto& i) { return i.param; });

/// Robots that are loaded from their URDF only.
class FromUrdfAlone : public ::testing::TestWithParam<const char*> {};

TEST_P(FromUrdfAlone, StandsAndTakesAPush) {
  const std::string name = GetParam();
  const Result<RobotModel> model = LoadRobot(SourceFolder() + "/robots/" + name + "/robot.urdf", "none");
  ASSERT_TRUE(model.ok()) << model.failure().message;
  const MotionPlan plan = standing::Plan(*model, 1.5);
  PlayOptions options;
  options.push_force_W = {0.03 * model->weight_n(), 0.05 * model->weight_n(), 0.0};
  options.push_at_s = 0.2;
  const PlaybackLog log = Play(*model, plan, *MakeStabilised(*model, plan, {}), options).value();
  EXPECT_TRUE(log.body_contacts.empty());
  EXPECT_EQ(log.stances.size(), model->feet.size()) << "no foot leaves the ground";
  const LogSample& end = log.samples.back();
  EXPECT_LT(end.v.head<6>().norm(), 0.01);
  EXPECT_LT((end.q - plan.whole_body.q.back()).head<7>().lpNorm<Eigen::Infinity>(), 0.005);
  const LogSample& pushed = log.samples[60];
  EXPECT_GT((pushed.q - plan.whole_body.q.back()).head<2>().norm(), 0.002) << "the push is felt";
}

INSTANTIATE_TEST_SUITE_P(Robots, FromUrdfAlone, ::testing::Values("a1", "nao"), [](const auto& i) { return i.param; });

TEST(Stabilised, RefusesOptionsOutOfRangeAndPlansOfOthers) {
  const RobotModel a1 = standing::Load("a1"), nao = standing::Load("nao");
  const MotionPlan plan = standing::Plan(a1, 0.1);
  const std::size_t fields = StabilisedOptions{}.Fields().size();
  EXPECT_GT(fields, 10U);
  for (std::size_t i = 0; i < fields; ++i) {
    for (const bool high : {false, true}) {
      StabilisedOptions options;
      const OptionField field = options.Fields()[i];
      *std::get<double*>(field.target) = high ? field.highest + 1.0 : field.lowest - 1.0;
      try {
        (void)MakeStabilised(a1, plan, options);
        ADD_FAILURE() << field.key;
      } catch (const InvalidArgument& refused) {
        EXPECT_NE(std::string(refused.what()).find(field.key), std::string::npos) << refused.what();
      }
    }
  }
  EXPECT_THROW((void)MakeStabilised(nao, plan, {}), InvalidArgument);
  EXPECT_THROW((void)MakeStabilised(a1, MotionPlan{}, {}), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
