// SPDX-License-Identifier: BSD-3-Clause
#include "planning/paths/body_space.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "kinematics/base/result.h"
#include "planning/paths/standing_feet.h"
#include "tests/named_robot.h"

namespace gaitwright {
namespace {

/// Lowest corner of a box.
Vector3 LowOf(const Shape& box) { return box.X_BS.translation() - 0.5 * box.size; }
Vector3 HighOf(const Shape& box) { return box.X_BS.translation() + 0.5 * box.size; }

class BodySpaceTest : public testing::TestWithParam<const char*> {};

TEST_P(BodySpaceTest, LengthsAreSharesOfTheLeg) {
  const RobotModel& model = NamedRobot(GetParam());
  BodySpaceOptions options;
  options.step_height = 0.25;
  options.foothold_forward = 0.4;
  options.foothold_lateral = 0.15;
  options.margin = 0.1;
  options.max_slope_deg = 20.0;
  const BodySpace space = BodySpaceOf(model, options);
  const double leg = model.leg_length_m();
  EXPECT_DOUBLE_EQ(space.leg_length_m, leg);
  EXPECT_DOUBLE_EQ(space.step_height_m, 0.25 * leg);
  EXPECT_DOUBLE_EQ(space.reach_forward_m, 0.4 * leg);
  EXPECT_DOUBLE_EQ(space.reach_lateral_m, 0.15 * leg);
  EXPECT_DOUBLE_EQ(space.margin_m, 0.1 * leg);
  EXPECT_DOUBLE_EQ(space.max_slope_rad, std::numbers::pi / 9.0);
}

TEST_P(BodySpaceTest, AMarginGrowsEachBoxByItToAllSidesButTheGround) {
  const RobotModel& model = NamedRobot(GetParam());
  BodySpaceOptions none, wide;
  none.margin = 0.0;
  wide.margin = 0.2;
  const BodySpace without = BodySpaceOf(model, none), with = BodySpaceOf(model, wide);
  ASSERT_EQ(without.boxes.size(), with.boxes.size());
  const double margin_m = 0.2 * model.leg_length_m();
  for (std::size_t i = 0; i < with.boxes.size(); ++i) {
    EXPECT_LT((HighOf(with.boxes[i]) - HighOf(without.boxes[i]) - Vector3::Constant(margin_m)).norm(), 1e-9);
    EXPECT_LT((LowOf(without.boxes[i]) - LowOf(with.boxes[i])).head<2>().norm() - std::sqrt(2.0) * margin_m, 1e-9);
    EXPECT_GE(LowOf(with.boxes[i]).z(), with.step_height_m - 1e-12) << "what is lower is stepped over";
  }
}

TEST_P(BodySpaceTest, StepsGrowTheBoxOfTheLegsAlone) {
  const RobotModel& model = NamedRobot(GetParam());
  BodySpaceOptions still, stepping;
  still.step_forward = still.step_lateral = 0.0;
  stepping.step_forward = 0.3;
  stepping.step_lateral = 0.1;
  const BodySpace a = BodySpaceOf(model, still), b = BodySpaceOf(model, stepping);
  ASSERT_EQ(a.boxes.size(), 2U);
  const double leg = model.leg_length_m();
  const Vector3 grown = b.boxes[0].size - a.boxes[0].size;
  EXPECT_NEAR(grown.x(), 0.6 * leg, 1e-9);
  EXPECT_NEAR(grown.y(), 0.2 * leg, 1e-9);
  EXPECT_NEAR(grown.z(), 0.0, 1e-9);
  EXPECT_LT((b.boxes[1].size - a.boxes[1].size).norm(), 1e-12);
}

TEST_P(BodySpaceTest, TheRadiusReachesTheFarthestCorner) {
  const BodySpace space = BodySpaceOf(NamedRobot(GetParam()), {});
  double farthest = 0.0;
  for (const Shape& box : space.boxes) {
    const Vector3 most = LowOf(box).cwiseAbs().cwiseMax(HighOf(box).cwiseAbs());
    farthest = std::max(farthest, most.head<2>().norm());
  }
  EXPECT_NEAR(space.radius_m, farthest, 1e-9);
}

TEST_P(BodySpaceTest, FeetStandAsTheyDoAndMirrorEachOther) {
  const RobotModel& model = NamedRobot(GetParam());
  const BodySpace space = BodySpaceOf(model, {});
  const std::vector<Pose> standing = StandingFeet(model);
  ASSERT_EQ(space.feet_G.size(), standing.size());
  for (std::size_t f = 0; f < standing.size(); ++f) {
    EXPECT_LT((space.feet_G[f] - standing[f].translation().head<2>()).norm(), 2e-3);
    const Vector2& other = space.feet_G[static_cast<std::size_t>(model.legs[f].mirror)];
    EXPECT_LT((space.feet_G[f] - Vector2(other.x(), -other.y())).norm(), 1e-12);
  }
}

TEST_P(BodySpaceTest, AHigherStepLiftsTheBottomOfTheRoom) {
  const RobotModel& model = NamedRobot(GetParam());
  double last = -1.0;
  for (const double step : {0.1, 0.3, 0.6}) {
    BodySpaceOptions options;
    options.step_height = step;
    double lowest = 1e9;
    for (const Shape& box : BodySpaceOf(model, options).boxes) lowest = std::min(lowest, LowOf(box).z());
    EXPECT_GT(lowest, last);
    last = lowest;
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, BodySpaceTest, testing::Values("a1", "nao"));

TEST(BodySpaceOfOptions, SwayMakesRoomForABipedOnly) {
  BodySpaceOptions still, swaying;
  still.sway = 0.0;
  swaying.sway = 1.0;
  const auto grown = [&](const char* robot) {
    const BodySpace a = BodySpaceOf(NamedRobot(robot), still), b = BodySpaceOf(NamedRobot(robot), swaying);
    return b.boxes[1].size.y() - a.boxes[1].size.y();
  };
  const std::vector<Vector2> feet = BodySpaceOf(NamedRobot("nao"), {}).feet_G;
  EXPECT_NEAR(grown("nao"), std::abs(feet[0].y() - feet[1].y()), 1e-9) << "half of it to both sides";
  EXPECT_EQ(grown("a1"), 0.0);
}

TEST(BodySpaceOfOptions, AFootNeedsGroundAsWideAsItself) {
  EXPECT_DOUBLE_EQ(BodySpaceOf(NamedRobot("a1"), {}).foot_radius_m, NamedRobot("a1").feet[0].radius);
  const BodySpace nao = BodySpaceOf(NamedRobot("nao"), {});
  double half_width = 0.0;
  for (const Vector2& corner : NamedRobot("nao").feet[0].sole_F)
    half_width = std::max(half_width, std::abs(corner.y()));
  EXPECT_NEAR(nao.foot_radius_m, half_width, 5e-3);
}

}  // namespace
}  // namespace gaitwright
