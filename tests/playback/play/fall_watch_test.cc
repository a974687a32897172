// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <memory>

#include "kinematics/spatial/rotation.h"
#include "playback/play/fall_watch_internal.h"
#include "playback/play/make_world.h"
#include "tests/playback/standing_plan.h"

namespace gaitwright::playing {
namespace {

constexpr double kDrop = 0.25;       // [m] of the plan at half time
constexpr double kAfterFall = 0.35;  // [s] after which a fall has ended a playback

/// A plan that stands, and after half a second stands a block lower; the robot is wherever a test puts it.
class FallWatchTest : public ::testing::Test {
 protected:
  static MotionPlan Dropping(const RobotModel& model) {
    MotionPlan plan = standing::Plan(model, 1.0);
    for (std::size_t row = plan.whole_body.q.size() / 2; row < plan.whole_body.q.size(); ++row)
      plan.whole_body.q[row][2] -= kDrop;
    return plan;
  }

  /// Whether the robot has fallen by a time, with its base lowered and rolled, and no foot on the ground.
  bool Falls(double time_s, double lowered_m, double roll_rad = 0.0) {
    FallWatch watch(model_, plan_, 0.4);
    watch.Start(0.0);
    VectorX q = plan_.whole_body.q.front();
    world_->SetState(q, VectorX::Zero(model_.nv()));
    watch.Add(0.0, *world_);
    q[2] -= lowered_m;
    q.segment<4>(3) = Quaternion(RotationExp(Vector3(roll_rad, 0.0, 0.0))).coeffs();
    world_->SetState(q, VectorX::Zero(model_.nv()));
    watch.Add(time_s, *world_);
    return watch.Over(time_s + kAfterFall);
  }

  const RobotModel model_ = standing::Load("a1");
  const MotionPlan plan_ = Dropping(model_);
  const std::unique_ptr<World> world_ = MakeWorld(model_, plan_.terrain, plan_.whole_body.q.front(), {});
};

TEST_F(FallWatchTest, ABaseFarBelowItsPlanHasFallen) {
  EXPECT_FALSE(Falls(0.2, 0.0));
  EXPECT_FALSE(Falls(0.2, 0.1));
  EXPECT_TRUE(Falls(0.2, kDrop));
}

TEST_F(FallWatchTest, ALateLandingOnLowerGroundIsNoFall) {
  EXPECT_FALSE(Falls(0.6, kDrop));
  EXPECT_FALSE(Falls(0.6, kDrop - 0.02));
}

TEST_F(FallWatchTest, ATiltFromThePlanIsAFall) {
  EXPECT_FALSE(Falls(0.2, 0.0, 0.9));
  EXPECT_TRUE(Falls(0.2, 0.0, 1.1));
}

}  // namespace
}  // namespace gaitwright::playing
