// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "kinematics/model/load_robot.h"
#include "kinematics/stability/standing_width_internal.h"
#include "tests/unusual_robots.h"

namespace gaitwright {
namespace {

TEST(StandingWidth, IsThatOfTheSolesOrOfNoneOnTwoPoints) {
  const RobotModel h1 = LoadNamedRobot("h1").value();
  double low = 1e9, high = -1e9;  // of a sole along its foot
  for (const Vector2& corner : h1.feet[0].sole_F) low = std::min(low, corner.x()), high = std::max(high, corner.x());
  EXPECT_NEAR(StandingWidth(h1), high - low, 0.02) << "the feet are farther apart than they are long";
  const RobotModel points = LoadRobotFromText(unusual::PointBiped(), "").value();
  EXPECT_NEAR(StandingWidth(points), 0.0, 1e-9);
  EXPECT_FALSE(CanStandStill(points));
  for (const char* name : {"a1", "nao", "h1"}) EXPECT_TRUE(CanStandStill(LoadNamedRobot(name).value())) << name;
  EXPECT_TRUE(CanStandStill(LoadRobotFromText(unusual::Tripod(), "").value()));
}

}  // namespace
}  // namespace gaitwright
