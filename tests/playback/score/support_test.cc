// SPDX-License-Identifier: BSD-3-Clause
#include "playback/score/support.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/playback/synthetic.h"

namespace gaitwright {
namespace {

Support StandingSupport(const RobotModel& model, FootSet stance) {
  DynamicsScratch scratch(model);
  ForwardKinematics(model, synthetic::StandingPlan(model, 0.1).whole_body.q[0], scratch);
  return SupportOf(model, scratch, FlatTerrain(), stance);
}

TEST(Support, OneSoleTwoSolesAndNone) {
  const RobotModel model = synthetic::Robot(2, FootType::kSole);
  const Support left = StandingSupport(model, 1), both = StandingSupport(model, 3);
  EXPECT_NEAR(Area(left.polygon), 0.16 * 0.08, 1e-12);
  EXPECT_NEAR(Area(both.polygon), 0.16 * 0.28, 1e-12);
  EXPECT_LT((left.reference_W - Vector3(0.0, 0.1, 0.0)).norm(), 1e-12);
  EXPECT_TRUE(HasArea(left));
  EXPECT_TRUE(StandingSupport(model, 0).empty());
}

TEST(Support, ASoleThatNoAnkleRollsHasNoAreaAlone) {
  const RobotModel model = synthetic::Robot(2, FootType::kLine);
  const Support left = StandingSupport(model, 1);
  EXPECT_FALSE(HasArea(left));
  EXPECT_NEAR(Area(left.polygon), 0.16 * 0.08, 1e-12);
  EXPECT_TRUE(HasArea(StandingSupport(model, 3)));
}

TEST(Support, ASoleOnItsFrontEdgeSupportsThereOnly) {
  const RobotModel model = synthetic::Robot(2, FootType::kSole);
  DynamicsScratch scratch(model);
  ForwardKinematics(model, synthetic::StandingPlan(model, 0.1).whole_body.q[0], scratch);
  const Support edge = SupportOf(model, scratch, FlatTerrain(), 1, 1),
                both = SupportOf(model, scratch, FlatTerrain(), 3, 1);
  ASSERT_EQ(edge.points_W.size(), 2u);
  for (const Vector3& p_W : edge.points_W) EXPECT_NEAR(p_W.x(), synthetic::kHalfLength, 1e-12);
  EXPECT_FALSE(HasArea(edge));
  // The other sole, and the triangle from its rear corners to the edge.
  EXPECT_NEAR(Area(both.polygon), 0.16 * 0.08 + 0.5 * 0.16 * 0.2, 1e-12);
}

TEST(Support, ASphereStandsARadiusBelowItsCentre) {
  const RobotModel model = synthetic::Robot(4, FootType::kSphere);
  const Support diagonal = StandingSupport(model, 0b1001);
  ASSERT_EQ(diagonal.points_W.size(), 2u);
  EXPECT_NEAR(diagonal.points_W[0].z(), 0.0, 1e-12);
  EXPECT_FALSE(HasArea(diagonal));
  EXPECT_TRUE(HasArea(StandingSupport(model, 0b0111)));
}

TEST(Support, TheMotionBetweenTwoSupportsUndoesDriftAndTurn) {
  const RobotModel model = synthetic::Robot(2, FootType::kSole);
  for (const double yaw : {0.0, 1e-9, 0.3, -2.0, std::numbers::pi - 0.01}) {
    for (const FootSet stance : {FootSet{1}, FootSet{3}}) {
      const Support planned = StandingSupport(model, stance);
      Support measured = planned;
      const Eigen::Rotation2Dd turn(yaw);
      const Vector2 d(0.4, -0.7);
      measured.reference_W.head<2>() = turn * Vector2(planned.reference_W.head<2>()) + d;
      for (Vector3& p : measured.points_W) p.head<2>() = turn * Vector2(p.head<2>()) + d;
      const SupportMotion motion = MotionBetween(planned, measured);
      EXPECT_NEAR(WrapAngle(motion.yaw_rad - yaw), 0.0, 1e-9);
      const Vector2 p(0.05, 0.02);
      EXPECT_LT((motion.Back(turn * p + d) - p).norm(), 1e-9);
    }
  }
}

TEST(Support, OnePointTurnsWithTheBase) {
  const RobotModel model = synthetic::Robot(4, FootType::kPoint);
  const Support planned = StandingSupport(model, 1);
  Support measured = planned;
  measured.base_yaw_rad += 0.4;
  EXPECT_NEAR(MotionBetween(planned, measured).yaw_rad, 0.4, 1e-12);
}

TEST(Support, GroundOfTwoHeightsHasNoZmp) {
  const RobotModel model = synthetic::Robot(2, FootType::kSole);
  DynamicsScratch scratch(model);
  ForwardKinematics(model, synthetic::StandingPlan(model, 0.1).whole_body.q[0], scratch);
  Terrain step = FlatTerrain();
  TerrainPatch block = step.patches[0];
  block.X_WT.translation() = Vector3(0.0, 0.1, 0.05);
  block.outline_T = {{-0.2, -0.09}, {0.2, -0.09}, {0.2, 0.09}, {-0.2, 0.09}};
  step.patches.push_back(block);
  EXPECT_TRUE(SupportOf(model, scratch, FlatTerrain(), 3).coplanar);
  EXPECT_FALSE(SupportOf(model, scratch, step, 3).coplanar);
  EXPECT_TRUE(SupportOf(model, scratch, step, 1).coplanar);
}

TEST(Support, ASolePartlyOnAHeightFieldCarriesWithAllOfIt) {
  const RobotModel model = synthetic::Robot(2, FootType::kSole);
  DynamicsScratch scratch(model);
  ForwardKinematics(model, synthetic::StandingPlan(model, 0.1).whole_body.q[0], scratch);
  Terrain terrain = FlatTerrain();
  terrain.patches[0].outline_T = {{-1.0, -1.0}, {-0.06, -1.0}, {-0.06, 1.0}, {-1.0, 1.0}};
  HeightField field;
  field.origin_W = Vector2(-0.06, -1.0);
  field.resolution_m = 0.02;
  field.columns = 60;
  field.rows = 101;
  field.height_m.assign(static_cast<std::size_t>(field.columns * field.rows), 0.0);
  terrain.height_fields.push_back(field);
  EXPECT_NEAR(Area(SupportOf(model, scratch, terrain, 1).polygon), 0.16 * 0.08, 1e-9);
}

TEST(Support, OnGroundThatIsNotWhereThePlanHasItASoleCarriesWithAllOfIt) {
  const RobotModel model = synthetic::Robot(2, FootType::kSole);
  DynamicsScratch scratch(model);
  VectorX q = synthetic::StandingPlan(model, 0.1).whole_body.q[0];
  q[2] += 0.003;
  q.segment<4>(3) << 0.0, std::sin(0.5 * 0.05), 0.0, std::cos(0.5 * 0.05);
  ForwardKinematics(model, q, scratch);
  EXPECT_NEAR(Area(SupportOf(model, scratch, FlatTerrain(), 1).polygon), 0.16 * 0.08, 1e-4);
  EXPECT_NEAR(Area(SupportOf(model, scratch, FlatTerrain(), 3).polygon), 0.16 * 0.28, 1e-3);
}

TEST(Support, ToesInOneLineToRoundingLoseNoCorner) {
  const RobotModel model = synthetic::Robot(2, FootType::kSole);
  VectorX q = synthetic::StandingPlan(model, 0.1).whole_body.q[0];
  DynamicsScratch scratch(model);
  for (int i = 0; i < 2000; ++i) {
    const double noise = 1e-11 * std::sin(12.9898 * i);
    q[7] = noise;
    q[10] = -0.7 * noise;
    q.segment<4>(3) << 0.0, 0.0, 1e-12 * std::cos(78.233 * i), 1.0;
    ForwardKinematics(model, q, scratch);
    EXPECT_NEAR(Area(SupportOf(model, scratch, FlatTerrain(), 3).polygon), 0.16 * 0.28, 1e-6);
  }
}

}  // namespace
}  // namespace gaitwright
