// SPDX-License-Identifier: BSD-3-Clause
// Plans that are played in two engines: both must pass.
#include <gtest/gtest.h>

#include "kinematics/base/result.h"
#include "optimisation/search/plan_walk.h"
#include "playback/control/joint_pd.h"
#include "playback/play/make_world.h"
#include "tests/named_robot.h"
#include "workflows/walk/walk_report.h"

namespace gaitwright {
namespace {

class EnginesTest : public testing::Test {
 protected:
  EnginesTest() {
    if (EngineNames().size() < 2) return;
    WalkRequest request;
    request.command.distance_m = 0.3;
    planned_.emplace(PlanWalk(model_, request).value());
    both_.play.world.engine = "both";
  }

  void SetUp() override {
    if (EngineNames().size() < 2) GTEST_SKIP() << "this program was built without MuJoCo";
  }

  const MotionPlan& plan() const { return planned_->motion.plan; }

  const RobotModel model_ = NamedRobot("a1");
  std::optional<PlannedWalk> planned_;
  PlayRequest both_;
};

TEST_F(EnginesTest, BothArePlayedAsEachAlone) {
  const PlayedWalk both = PlayWalk(model_, plan(), both_).value();
  ASSERT_NE(both.second, nullptr);
  EXPECT_TRUE(both.pass());
  EXPECT_EQ(EngineOf(both.log), "bullet");
  EXPECT_EQ(EngineOf(both.second->log), "mujoco");
  for (const ScoredPlayback* one :
       {static_cast<const ScoredPlayback*>(&both), static_cast<const ScoredPlayback*>(both.second.get())}) {
    PlayRequest alone;
    alone.play.world.engine = EngineOf(one->log);
    const PlayedWalk played = PlayWalk(model_, plan(), alone).value();
    EXPECT_EQ(played.second, nullptr);
    EXPECT_EQ(played.report, one->report) << EngineOf(one->log);
  }
  EXPECT_EQ(both.second->agreement.name_a, "bullet");
  EXPECT_EQ(both.score(), std::min(both.report.score, both.second->report.score));
}

TEST_F(EnginesTest, AFallInOneIsAFail) {
  PlayedWalk played = PlayWalk(model_, plan(), both_).value();
  SecondPlayback fallen = *played.second;
  fallen.report.pass = false;
  fallen.report.score = 20.0;
  played.second = std::make_shared<const SecondPlayback>(fallen);
  EXPECT_FALSE(played.pass());
  EXPECT_EQ(&played.decisive(), played.second.get());
  EXPECT_EQ(played.score(), 20.0);
  const Judged judged{model_, plan(), played, planned_->audit};
  EXPECT_FALSE(judged.pass());
}

TEST_F(EnginesTest, AnOwnControllerPlaysInBothFromItsStart) {
  const PlayedWalk both = PlayWalk(model_, plan(), both_, std::make_unique<JointPd>(model_, plan())).value();
  PlayRequest alone;
  alone.controller = "joint-pd";
  alone.play.world.engine = "mujoco";
  const PlayedWalk mujoco = PlayWalk(model_, plan(), alone).value();
  ASSERT_NE(both.second, nullptr);
  ASSERT_EQ(both.second->log.samples.size(), mujoco.log.samples.size());
  EXPECT_EQ(both.second->log.samples.back().q, mujoco.log.samples.back().q);
}

TEST_F(EnginesTest, AWorldHasOne) {
  WorldOptions options;
  options.engine = "both";
  EXPECT_THROW(MakeWorld(model_, FlatTerrain(), plan().whole_body.q.front(), options), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
