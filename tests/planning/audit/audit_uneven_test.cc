// SPDX-License-Identifier: BSD-3-Clause
// The checks on uneven ground: good plans remain good when they are moved together with their ground. Obstacles in
// their path are found even if no single point under the feet touches them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kinematics/collision/shape_extent.h"
#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/spatial/rotation.h"
#include "tests/planning/audit/good_plan.h"
#include "tests/planning/audit/uneven_plans.h"

namespace gaitwright {
namespace {

class AuditUneven : public testing::TestWithParam<std::string> {
 protected:
  const RobotModel& model() const { return GoodPlanOf(GetParam()).model; }
  const MotionPlan& good() const { return GoodPlanOf(GetParam()).plan; }
  const std::string& foot() const { return model().feet[0].name; }
  double mid_swing_s() const { return TimeOf(good(), MidSwingRow(good())); }
  std::string Text(const MotionPlan& plan) const { return AuditText(Audit(model(), plan, {}).value()); }
};

INSTANTIATE_TEST_SUITE_P(Robots, AuditUneven, testing::Values("a1", "nao"),
                         [](const auto& robot) { return robot.param; });

Pose Elsewhere() {
  Pose X = Pose::Identity();
  X.translation() = Vector3(0.3, -0.2, 0.45);
  X.linear() = YawRotation(0.7);
  return X;
}

Obstacle Box(const Vector3& middle_W, const Vector3& size_m) {
  Obstacle box;
  box.name = "box";
  box.X_WO.translation() = middle_W;
  box.size_m = size_m;
  return box;
}

TEST_P(AuditUneven, APlanIsAsGoodOnAPlateau) {
  MotionPlan plan = CarriedWithGround(Elsewhere(), good());
  EXPECT_TRUE(Audit(model(), plan, {})->pass()) << Text(plan);
  CutToSlab(plan, 2.0);
  EXPECT_TRUE(Audit(model(), plan, {})->pass()) << Text(plan);
}

TEST_P(AuditUneven, APlanIsAsGoodOnALevelField) {
  MotionPlan plan = CarriedWithGround(Elsewhere(), good());
  ReplaceByField(plan, 0.45);
  EXPECT_TRUE(Audit(model(), plan, {})->pass()) << Text(plan);
  ReplaceByField(plan = CarriedWithGround(Elsewhere(), good()), 0.45 + 0.012);
  const auto found = ViolationsOf(model(), plan);
  EXPECT_NEAR(At(found, foot() + " foothold off its patch").value, 0.012, 1e-4);
  const auto sunk =
      std::find_if(found.begin(), found.end(), [](const auto& v) { return v.law == Law::kFootClearance; });
  ASSERT_NE(sunk, found.end());
  EXPECT_NEAR(sunk->value, -0.012, 2e-3);
}

TEST_P(AuditUneven, ARobotStandsOnASlope) {
  const double angle_rad = 0.09;
  const Matrix3 tilt = RotationExp(angle_rad * Vector3(0.3, -1.0, 0.0).normalized());
  const MotionPlan plan = StandOnSlope(model(), good(), tilt);
  EXPECT_TRUE(Audit(model(), plan, {})->pass()) << Text(plan);

  MotionPlan icy = plan;
  icy.terrain.patches[0].friction = 0.8 * std::tan(angle_rad);
  const auto slips = ViolationsOf(model(), icy);
  EXPECT_EQ(LawsOf(slips), std::vector<Law>{Law::kFrictionCone});

  MotionPlan out = plan;
  for (Vector2& p : out.centroidal.p_WZ) p.y() += 0.4;
  EXPECT_EQ(LawsOf(ViolationsOf(model(), out)), (std::vector<Law>{Law::kConsistency, Law::kZmpSupport}));

  MotionPlan level = plan;  // the same robot on level ground
  level.terrain = FlatTerrain();
  EXPECT_GT(At(ViolationsOf(model(), level), foot() + " foothold tilted from its patch").value, 0.9 * angle_rad);
}

TEST_P(AuditUneven, FootClearanceFindsARiserBesideASwing) {
  // Half a radius, or 4 mm, into the foot's outer side: the points under the foot miss it.
  const Foot& of_foot = model().feet[0];
  const Moment moment(model(), good(), mid_swing_s());
  const Pose X_WF = FramePose(moment.scratch, of_foot.body, of_foot.X_BF);
  double side = of_foot.radius;
  for (const Vector2& corner : of_foot.sole_F) side = std::max(side, corner.y());
  const double into = of_foot.sole_F.empty() ? 0.5 * of_foot.radius : 0.004, above = 0.004;
  constexpr double kThin = 1e-3;
  TerrainPatch riser;
  riser.name = "riser";
  riser.X_WT.translation() = X_WF.translation() + Vector3(0.0, side - into, above);
  riser.outline_T = {{-kThin, 0.0}, {kThin, 0.0}, {kThin, 0.05}, {-kThin, 0.05}};
  for (const Vector3& p : ContactPoints(model(), moment.scratch, 0)) {
    const Vector3 p_T = riser.X_WT.inverse() * p;
    ASSERT_TRUE(std::abs(p_T.x()) > 2.0 * kThin || p_T.y() < 0.0) << "a point stands over it";
  }
  MotionPlan plan = good();
  plan.terrain.patches.push_back(riser);
  const auto found = ViolationsOf(model(), plan);
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found[0].law, Law::kFootClearance);
  const Violation& hit = At(found, foot());
  EXPECT_LE(hit.value, -0.8 * std::min(into, above));
  // An equally thin riser 0.1 m farther out is no obstacle.
  plan.terrain.patches.back().X_WT.translation().y() += 0.1;
  EXPECT_EQ(Text(plan).find("foot_clearance"), std::string::npos) << Text(plan);
}

TEST_P(AuditUneven, BodyClearanceFindsALintelOverTheBody) {
  double top = 0.0;
  const Shape* highest = nullptr;
  for (const double time_s : SampleTimes(good())) {
    const Moment moment(model(), good(), time_s);
    for (const Shape& shape : model().collision_shapes) {
      const Pose X_WS = FramePose(moment.scratch, shape.body, shape.X_BS);
      const Vector3 point = X_WS * SupportPoint(shape, X_WS.linear().row(2).transpose());
      if (point.z() > top) top = point.z(), highest = &shape;
    }
  }
  ASSERT_NE(highest, nullptr);
  constexpr double kInto = 0.005;
  MotionPlan plan = good();
  plan.terrain.obstacles = {Box({0.0, 0.0, top + 0.1 - kInto}, {4.0, 4.0, 0.2})};
  const auto found = ViolationsOf(model(), plan);
  EXPECT_EQ(LawsOf(found), std::vector<Law>{Law::kBodyClearance});
  EXPECT_NEAR(At(found, highest->link).value, -kInto, 5e-4);
  plan.terrain.obstacles[0].X_WO.translation().z() += kInto + 1e-4;
  EXPECT_TRUE(Audit(model(), plan, {})->pass()) << Text(plan);
}

TEST_P(AuditUneven, BodyClearanceFindsAWallThroughTheShank) {
  const int knee = model().legs[0].knee_joint;
  const Moment moment(model(), good(), mid_swing_s());
  const auto shank = std::find_if(model().collision_shapes.begin(), model().collision_shapes.end(),
                                  [&](const Shape& shape) { return shape.body == knee + 1; });
  ASSERT_NE(shank, model().collision_shapes.end());
  const Vector3 middle = FramePose(moment.scratch, shank->body, shank->X_BS).translation();
  MotionPlan plan = good();
  plan.terrain.obstacles = {Box(middle, Vector3::Constant(0.004))};
  const auto found = ViolationsOf(model(), plan);
  const Violation& hit = At(found, shank->link);
  EXPECT_EQ(hit.law, Law::kBodyClearance);
  EXPECT_NEAR(hit.at_s, mid_swing_s(), 0.1);
  EXPECT_LT(hit.value, -0.002);
}

TEST_P(AuditUneven, HeldAgainstItOrNotAnObstacleFarAwayChangesNothing) {
  MotionPlan plan = good();
  plan.terrain.obstacles = {Box({0.0, 3.0, 0.5}, {10.0, 0.1, 1.0}), Box({0.0, -3.0, 0.5}, {10.0, 0.1, 1.0})};
  EXPECT_TRUE(Audit(model(), plan, {})->pass()) << Text(plan);
}

/// The robot stands as before, but one foot and its ground are 2 cm below the plane of the others, so there is no ZMP.
TEST(AuditOnContactsInNoPlane, HoldsTheWrenchAgainstTheConeWhereTheForcesDoNotGiveIt) {
  const GoodPlan& a1 = GoodPlanOf("a1");
  const MotionPlan still = StandOnSlope(a1.model, a1.plan, Matrix3::Identity());
  const auto cone_of = [&](const MotionPlan& plan) {
    const auto found = ViolationsOf(a1.model, plan);
    const auto at =
        std::find_if(found.begin(), found.end(), [](const auto& v) { return v.where == "contact wrench cone"; });
    return at == found.end() ? 0.0 : at->value;
  };
  const int dof = a1.model.joints[static_cast<std::size_t>(a1.model.legs[0].knee_joint)].dof;
  MotionPlan uneven = still;  // a bent knee lifts its foot off the plane of the other three
  for (VectorX& q : uneven.whole_body.q) q[7 + dof] -= 0.15;
  EXPECT_EQ(cone_of(uneven), 0.0) << "the wrench is inside, though the forces do not give it";
  for (VectorX& a : uneven.whole_body.a) a[1] += 7.0;  // needs a large lateral force
  EXPECT_GT(cone_of(uneven), 0.01);
  MotionPlan level = still;
  for (VectorX& a : level.whole_body.a) a[1] += 7.0;
  EXPECT_EQ(cone_of(level), 0.0) << "there the ZMP tells";
  EXPECT_GT(At(ViolationsOf(a1.model, level), "zero-moment point").value, 0.0);
}

TEST(AuditInAValley, HoldsTheWrenchAgainstTheConeWhereContactsPullOffTheirPlane) {
  const GoodPlan& a1 = GoodPlanOf("a1");
  // It stands on faces that slope towards its middle, and is accelerated laterally by more than gravity can hold.
  const auto pushed = [&](double fall_rad, double friction) {
    MotionPlan plan = StandOnSlope(a1.model, a1.plan, Matrix3::Identity());
    for (Foothold& foothold : plan.footsteps.footholds) {
      const double side = foothold.X_WF.translation().y() > 0.0 ? 1.0 : -1.0;
      foothold.X_WF.linear() = RotationExp(side * fall_rad * Vector3::UnitX());
    }
    for (VectorX& a : plan.whole_body.a) a[1] += 7.0;
    plan.terrain.patches[0].friction = friction;
    std::vector<std::string> where;
    for (const Violation& violation : ViolationsOf(a1.model, plan)) {
      if (violation.law == Law::kZmpSupport) where.push_back(violation.where);
    }
    return where;
  };
  const double friction = 0.8, beyond_rad = 1.2, within_rad = 0.8;  // and a friction cone of 0.675 rad about each
  EXPECT_EQ(pushed(0.0, friction), std::vector<std::string>{"zero-moment point"});
  EXPECT_EQ(pushed(within_rad, friction), std::vector<std::string>{"zero-moment point"});
  EXPECT_EQ(pushed(beyond_rad, friction), std::vector<std::string>{}) << "faces on either side hold it between them";
  EXPECT_EQ(pushed(beyond_rad, 0.1), std::vector<std::string>{"zero-moment point"});
  const double overhang_rad = 1.8;
  EXPECT_EQ(pushed(overhang_rad, 0.1), std::vector<std::string>{"contact wrench cone"}) << "these push down";
}

}  // namespace
}  // namespace gaitwright
