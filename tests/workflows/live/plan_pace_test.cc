// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <numbers>

#include "tests/named_robot.h"
#include "workflows/live/walk_stream.h"

namespace gaitwright {
namespace {

WalkPace TrotAt(double speed_m_s) { return {.gait = "trot", .speed_m_s = speed_m_s}; }

TEST(PlanPace, AChangeIsSaidByWhereItGoes) {
  PaceChange change{TrotAt(0.3), TrotAt(0.5)};
  EXPECT_EQ(TextOf(change), "trot at 0.5 m/s");
  change.to.lateral_speed_m_s = -0.1;
  change.to.yaw_rate_rad_s = 0.25;
  EXPECT_EQ(TextOf(change), "trot at 0.5 m/s, -0.1 m/s lateral, turning at 0.25 rad/s");
  change.to = TrotAt(0.5);
  change.turn_rad = -0.5 * std::numbers::pi;
  EXPECT_EQ(TextOf(change), "trot at 0.5 m/s, after a turn of -90 degrees");
}

TEST(PlanPace, APaceWithoutSpeedsStands) {
  EXPECT_TRUE(WalkPace{.gait = "trot"}.stands());
  EXPECT_TRUE((WalkPace{.gait = kStanding, .speed_m_s = 1.0}.stands()));
  EXPECT_FALSE(TrotAt(0.1).stands());
  EXPECT_FALSE((WalkPace{.gait = "trot", .yaw_rate_rad_s = -0.1}.stands()));
}

TEST(PlanPace, TheUsualPaceIsTheRobotsOwnGaitAtItsOwnSpeed) {
  const RobotModel model = NamedRobot("a1");
  const WalkPace pace = UsualPace(model, {});
  EXPECT_EQ(pace.speed_m_s, model.nominal_speed_m_s);
  EXPECT_FALSE(pace.gait.empty());
  EXPECT_FALSE(pace.stands());
}

TEST(PlanPace, AGaitThatDoesNotExistIsRefusedBeforeAnythingIsPlanned) {
  const Result<PacePlan> plan = PlanPace(NamedRobot("a1"), {TrotAt(0.3), {.gait = "gallopp", .speed_m_s = 0.5}}, {});
  ASSERT_FALSE(plan.ok());
  EXPECT_EQ(plan.failure().code, FailureCode::kGait);
  EXPECT_NE(plan.failure().message.find("'gallopp'"), std::string::npos);
}

}  // namespace
}  // namespace gaitwright
