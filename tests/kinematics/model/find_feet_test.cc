// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/find_feet.h"

#include <limits>

#include "kinematics/base/result.h"
#include "kinematics/spatial/convex_hull.h"
#include "kinematics/stability/polygon.h"
#include "tests/kinematics/made_robots.h"
#include "tests/kinematics/model/small_urdf.h"
#include "tests/unusual_robots.h"

namespace gaitwright {
namespace {

/// The result of FindFoot for the first leg of a robot.
Foot FootFoundIn(const RobotModel& model, const FootOverride* given = nullptr, const LegChoices& choices = {}) {
  const VectorX none = VectorX::Constant(model.num_dofs(), std::numeric_limits<double>::quiet_NaN());
  return FindFoot(model, model.legs[0], choices, given, none);
}

Foot FootOfShape(const std::string& shape) { return FootFoundIn(*LoadRobotFromText(FourLegs(shape), "")); }

TEST(FindFeet, ALegOfFewJointsEndsInABallOrAPoint) {
  const Foot ball = FootOfShape("<sphere radius='0.02'/>");
  EXPECT_EQ(ball.type, FootType::kSphere);
  EXPECT_EQ(ball.radius, 0.02);
  EXPECT_LT((ball.X_BF.translation() - Vector3(0, 0, -0.2)).norm(), 1e-12);
  EXPECT_EQ(ball.link, "A_foot");
  const Foot box = FootOfShape("<box size='0.1 0.06 0.02'/>");
  EXPECT_EQ(box.type, FootType::kPoint) << "no sole without an ankle";
  EXPECT_LT((box.X_BF.translation() - Vector3(0, 0, -0.21)).norm(), 1e-12) << "the middle of the farthest corners";
  EXPECT_EQ(FootOfShape("<sphere radius='0.0005'/>").type, FootType::kPoint) << "a ball of less than a millimetre";
}

TEST(FindFeet, ABipedOfOneAnkleJointStandsOnItsSoles) {
  unusual::UrdfText urdf;
  urdf.Link("body", 8.0, 0.25, urdf.Block(0.15, 0.2, 0.2, -0.1));
  for (const double side : {1.0, -1.0}) {
    const std::string n = side > 0.0 ? "l" : "r";
    for (const char* part : {"1", "2", "3"}) urdf.Link(n + part, 0.5, 0.15);
    urdf.Link(n + "_foot", 0.5, 0.12, urdf.Block(0.2, 0.1, 0.02, 0.04));
    urdf.Joint("body", n + "1", {0.0, 0.1 * side, -0.05}, {.axis = "1 0 0", .lower = -0.6, .upper = 0.6});
    urdf.Joint(n + "1", n + "2", {0.0, 0.0, 0.0}, {});
    urdf.Joint(n + "2", n + "3", {0.0, 0.0, -0.25}, {.lower = 0.0, .upper = 2.2});
    urdf.Joint(n + "3", n + "_foot", {0.0, 0.0, -0.25}, {.lower = -1.0, .upper = 1.0});
  }
  const RobotModel model = LoadRobotFromText(urdf.Done("one_ankle_joint"), "").value();
  ASSERT_EQ(model.feet.size(), 2U);
  for (const Foot& foot : model.feet) {
    EXPECT_EQ(foot.type, FootType::kLine);
    EXPECT_NEAR(Area(foot.sole_F), 0.2 * 0.1, 1e-9);
  }
}

TEST(FindFeet, WithoutShapesTheFarthestFrameIsThePoint) {
  RobotModel model = *LoadRobotFromText(FourLegs(), "");
  model.collision_shapes.clear();
  const Foot foot = FootFoundIn(model);
  EXPECT_EQ(foot.type, FootType::kPoint);
  EXPECT_EQ(foot.link, "A_foot");
  EXPECT_EQ(foot.radius, 0.0);
  EXPECT_NEAR(FarthestExtent(model, foot.body), 0.2, 1e-12);
}

TEST(FindFeet, TheExtentIsThatOfTheFarthestSurface) {
  const RobotModel model = *LoadRobotFromText(FourLegs(), "");
  EXPECT_NEAR(FarthestExtent(model, model.feet[0].body), 0.22, 1e-12);
  EXPECT_NEAR(FarthestExtent(model, 0), Vector3(0.2, 0.1, 0.05).norm(), 1e-12);
}

TEST(FindFeet, AnAnkleThatRollsHasASoleAndOthersALine) {
  const RobotModel six = Made(SixJoints());
  const Foot sole = FootFoundIn(six);
  EXPECT_EQ(sole.type, FootType::kSole);
  EXPECT_NEAR(Area(sole.sole_F), 0.2 * 0.1, 1e-12);
  EXPECT_LT((sole.X_BF.translation() - Vector3(0.02, 0.0, -0.05)).norm(), 1e-9);
  std::vector<SyntheticJoint> five = SixJoints();
  five.pop_back();
  EXPECT_EQ(FootFoundIn(Made(five)).type, FootType::kLine);
}

TEST(FindFeet, WhatTheUserGivesComesFirst) {
  const RobotModel model = Made(SixJoints());
  FootOverride given;
  given.link = "l5";
  given.type = FootType::kPoint;
  const Foot point = FootFoundIn(model, &given);
  EXPECT_EQ(point.type, FootType::kPoint);
  EXPECT_TRUE(point.sole_F.empty());
  given.type.reset();
  given.radius_m = 0.03;
  const Foot ball = FootFoundIn(model, &given);
  EXPECT_EQ(ball.type, FootType::kSphere);
  EXPECT_EQ(ball.radius, 0.03);
  given.radius_m = 0.0;
  given.type = FootType::kSphere;
  EXPECT_THROW(FootFoundIn(model, &given), InvalidArgument) << "a box has no radius";
}

TEST(FindFeet, AGivenSoleIsPutAboutItsMiddle) {
  const RobotModel model = Made(SixJoints());
  FootOverride given;
  given.link = "l5";
  given.sole_m = {{0.0, 0.0}, {0.2, 0.0}, {0.2, 0.1}, {0.0, 0.1}};
  const Foot foot = FootFoundIn(model, &given);
  EXPECT_EQ(foot.type, FootType::kSole);
  EXPECT_LT((foot.X_BF.translation() - Vector3(0.1, 0.05, 0.0)).norm(), 1e-12);
  EXPECT_LT(Centroid(foot.sole_F).norm(), 1e-12);
  EXPECT_NEAR(Area(foot.sole_F), 0.02, 1e-12);
}

TEST(FindFeet, ASoleGiveThatChangesNothingIsRefused) {
  const RobotModel balls = *LoadRobotFromText(FourLegs(), "");
  FootOverride given;
  given.link = "A_foot";
  given.sole_give_m = 0.003;
  EXPECT_THROW(FootFoundIn(balls, &given), InvalidArgument);
  LegChoices choices;
  choices.sole_give_m = 0.003;
  EXPECT_EQ(FootFoundIn(balls, nullptr, choices).type, FootType::kSphere) << "one for all feet need not fit each";
}

TEST(FindRest, IsTheFlatBottomOfALinkAndNotOfOthers) {
  const RobotModel model = *LoadRobotFromText(FourLegs(), "");
  const std::optional<Foot> trunk = FindRest(model, "trunk");
  ASSERT_TRUE(trunk.has_value());
  EXPECT_EQ(trunk->type, FootType::kSole);
  EXPECT_NEAR(Area(trunk->sole_F), 0.4 * 0.2, 1e-12);
  EXPECT_FALSE(FindRest(model, "A_foot").has_value()) << "a ball";
  EXPECT_FALSE(FindRest(model, "A_thigh").has_value()) << "no shape";
  EXPECT_THROW(FindRest(model, "tail"), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
