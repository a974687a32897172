// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/leg_plane.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/model/body_tree.h"
#include "kinematics/model/load_robot.h"
#include "kinematics/spatial/convex_hull.h"
#include "tests/unusual_robots.h"

namespace gaitwright {
namespace {

RobotModel Loaded(const std::string& urdf) {
  const Result<RobotModel> model = LoadRobotFromText(urdf, "");
  EXPECT_TRUE(model.ok()) << model.failure().message;
  return *model;
}

std::vector<Vector3> StandingContacts(const RobotModel& model, Vector3& p_WC) {
  DynamicsScratch scratch(model);
  ForwardKinematics(model, StandingConfiguration(model), scratch);
  p_WC = CentreOfMass(model, scratch);
  std::vector<Vector3> contacts;
  for (int f = 0; f < static_cast<int>(model.feet.size()); ++f)
    contacts.push_back(ContactFrame(model, scratch, f).translation());
  return contacts;
}

TEST(LegPlane, AStrokeIsPartOfALeg) {
  const RobotModel model = Loaded(unusual::Telescopic());
  for (const Leg& leg : model.legs) {
    EXPECT_NEAR(leg.length_m, 0.2 + 0.15 + 0.1 + 0.02, 1e-12);
    EXPECT_EQ(leg.hip_joint, leg.joints[1]);
    // The prismatic joint can move in both directions.
    const int dof = model.joints[static_cast<std::size_t>(leg.joints[2])].dof;
    EXPECT_GT(model.standing_joints[dof], 0.03);
    EXPECT_LT(model.standing_joints[dof], 0.12);
  }
}

TEST(LegPlane, ALegThatSprawlsBendsInItsOwnPlane) {
  const RobotModel model = Loaded(unusual::Insect());
  Vector3 p_WC;
  const std::vector<Vector3> contacts = StandingContacts(model, p_WC);
  DynamicsScratch scratch(model);
  ForwardKinematics(model, StandingConfiguration(model), scratch);
  for (const Leg& leg : model.legs) {
    const Foot& foot = model.feet[static_cast<std::size_t>(leg.foot)];
    const LegPlane plane = FindLegPlane(model, leg, foot);
    EXPECT_TRUE(plane.sprawls);
    EXPECT_EQ(plane.joints, (std::vector<int>{leg.joints[1], leg.joints[2]}));
    EXPECT_EQ(leg.knee_joint, leg.joints[2]);
    EXPECT_GT(KneeBend(model, leg, foot, model.standing_joints) * leg.knee_sign, 0.3);
    const Vector3 coxa = scratch.p_WB[static_cast<std::size_t>(leg.joints[0]) + 1];
    const Vector3 hip = scratch.p_WB[static_cast<std::size_t>(leg.hip_joint) + 1];
    const Vector3 knee = scratch.p_WB[static_cast<std::size_t>(leg.knee_joint) + 1];
    const Vector3& contact = contacts[static_cast<std::size_t>(leg.foot)];
    EXPECT_GT(knee.z(), hip.z() - 0.05);
    // The foot is as far out as it is below, and away from the body.
    EXPECT_NEAR((contact - coxa).head<2>().norm(), hip.z() - contact.z() - foot.radius, 0.02);
    EXPECT_GT((contact - coxa).head<2>().dot(coxa.head<2>()), 0.0);
  }
}

TEST(LegPlane, AWheelDoesNotBendItsLeg) {
  const RobotModel model = Loaded(unusual::Wheeled());
  for (const Leg& leg : model.legs) {
    ASSERT_EQ(leg.joints.size(), 4U);
    const LegPlane plane = FindLegPlane(model, leg, model.feet[static_cast<std::size_t>(leg.foot)]);
    EXPECT_EQ(plane.joints, (std::vector<int>{leg.joints[1], leg.joints[2]}));
    EXPECT_NEAR(leg.length_m, 0.4 + 0.08, 1e-12);
  }
}

/// A biped whose knees are beside its hips, and whose ankle roll axes start behind its ankles.
/// @param tilt  of its soles at joint positions zero, toes up [rad]. @param type  of its joints in the plane of a leg.
std::string OffsetBiped(double tilt = 0.0, const std::string& type = "revolute") {
  unusual::UrdfText urdf;
  urdf.Link("trunk", 10.0, 0.3, urdf.Block(0.15, 0.2, 0.3));
  for (const double side : {1.0, -1.0}) {
    const std::string n = side > 0.0 ? "l_" : "r_";
    const auto add = [&](const std::string& parent, const std::string& child, const Vector3& at, const char* axis,
                         const std::string& kind, const std::string& shape = "") {
      urdf.Link(n + child, 0.5, 0.1, shape);
      urdf.Joint(parent, n + child, {at.x(), side * at.y(), at.z()}, {.type = kind, .axis = axis, .effort = 100.0});
    };
    const std::string sole = fmt::format(
        "<collision><origin xyz='0.05 0 -0.05' rpy='0 {} 0'/><geometry><box size='0.2 0.1 "
        "0.02'/></geometry></collision>",
        -tilt);
    add("trunk", "yaw", {0.0, 0.1, -0.15}, "0 0 1", "revolute");
    add(n + "yaw", "roll", {0.0, 0.0, 0.0}, "1 0 0", "revolute");
    add(n + "roll", "thigh", {0.0, 0.0, 0.0}, "0 1 0", type);
    add(n + "thigh", "shank", {0.0, 0.05, -0.3}, "0 1 0", type);
    add(n + "shank", "ankle", {0.0, -0.05, -0.3}, "0 1 0", type);
    add(n + "ankle", "foot", {-0.04, 0.03, 0.0}, "1 0 0", "revolute", sole);
  }
  return urdf.Done("offset_biped");
}

TEST(LegPlane, WhatLiesBesideAJointMakesNoLegLonger) {
  const RobotModel model = Loaded(OffsetBiped());
  ASSERT_EQ(model.legs.size(), 2U);
  for (const Leg& leg : model.legs) {
    EXPECT_NEAR(leg.length_m, 0.3 + 0.3 + 0.06, 1e-12);
    const Foot& foot = model.feet[static_cast<std::size_t>(leg.foot)];
    EXPECT_NEAR(std::cos(0.5 * KneeBend(model, leg, foot, model.standing_joints)), 0.92, 0.01);
  }
}

/// A knee without limits bends forward if it is bent forward at zero, and otherwise as quadrupeds usually do.
TEST(LegPlane, AKneeWithoutLimitsBendsAsItIsDrawn) {
  for (const double drawn : {0.0, 0.05, -0.05}) {
    unusual::UrdfText urdf;
    urdf.Link("trunk", 5.0, 0.3, urdf.Block(0.4, 0.2, 0.1));
    for (const unusual::Hip& hip : unusual::Four()) {
      const std::string& n = hip.name;
      urdf.Link(n + "1", 0.4, 0.08);
      urdf.Link(n + "2", 0.7, 0.2);
      urdf.Link(n + "3", 0.25, 0.2);
      urdf.Link(n + "_foot", 0.05, 0.05, urdf.Ball(0.02));
      urdf.Joint("trunk", n + "1", {hip.x, hip.y, 0.0}, {.axis = "1 0 0"});
      urdf.Joint(n + "1", n + "2", {0.0, 0.0, 0.0}, {});
      urdf.Joint(n + "2", n + "3", {0.0, 0.0, -0.2}, {.type = "continuous"});
      urdf.Joint(n + "3", n + "_foot", {drawn, 0.0, -0.2}, {.type = "fixed"});
    }
    const RobotModel model = Loaded(urdf.Done("drawn"));
    for (const Leg& leg : model.legs) EXPECT_EQ(leg.knee_sign, drawn < 0.0 ? 1.0 : -1.0) << drawn;
  }
}

TEST(StandingPosture, TurnsNoJointByAFullTurn) {
  const RobotModel model = Loaded(OffsetBiped(0.0, "continuous"));
  for (const Leg& leg : model.legs) {
    const Foot& foot = model.feet[static_cast<std::size_t>(leg.foot)];
    EXPECT_GT(std::abs(KneeBend(model, leg, foot, model.standing_joints)), 0.3);
  }
  EXPECT_LT(model.standing_joints.cwiseAbs().maxCoeff(), 1.5);
}

TEST(StandingPosture, ASoleThatIsAslantAtZeroIsLevelInAGivenOne) {
  const std::string posture =
      "standing: {l_yaw_joint: 0.1, l_roll_joint: 0, l_thigh_joint: -0.4, l_shank_joint: 0.8, l_ankle_joint: -0.19, "
      "l_foot_joint: 0, r_yaw_joint: -0.1, r_roll_joint: 0, r_thigh_joint: -0.4, r_shank_joint: 0.8, r_ankle_joint: "
      "-0.19, r_foot_joint: 0}";
  const Result<RobotModel> model = LoadRobotFromText(OffsetBiped(0.2), posture);
  ASSERT_TRUE(model.ok()) << model.failure().message;
  const std::vector<Pose> X_OB = BodyPoses(*model, VectorX::Zero(model->num_dofs()));
  for (const Foot& foot : model->feet) {
    ASSERT_EQ(foot.type, FootType::kSole);
    EXPECT_NEAR(Area(foot.sole_F), 0.2 * 0.1, 1e-9);
    // The frame of the sole is that of the box, which is rotated by the tilt at zero, even if the posture does not
    // level it.
    const Matrix3 R_OF = X_OB[static_cast<std::size_t>(foot.body)].linear() * foot.X_BF.linear();
    EXPECT_LT((R_OF - Eigen::AngleAxisd(-0.2, Vector3::UnitY()).toRotationMatrix()).norm(), 1e-9);
  }
}

TEST(StandingPosture, StandsUnderItsCentreOfMass) {
  for (const std::string& urdf : {unusual::Plain(), unusual::Telescopic(), unusual::Insect(), unusual::PointBiped(),
                                  unusual::Tripod(), unusual::ArmAndTail(), LoadNamedRobot("a1")->urdf_text}) {
    const RobotModel model = Loaded(urdf);
    Vector3 p_WC, middle = Vector3::Zero();
    const std::vector<Vector3> contacts = StandingContacts(model, p_WC);
    for (const Vector3& p : contacts) {
      EXPECT_NEAR(p.z(), 0.0, 1e-6);
      middle += p / static_cast<double>(contacts.size());
    }
    EXPECT_LT((p_WC - middle).head<2>().norm(), 1e-6) << model.name;
  }
}

/// A robot of twice the size stands twice as high.
TEST(StandingPosture, ScalesWithTheRobot) {
  const RobotModel one = Loaded(unusual::Plain()), large = Loaded(unusual::Plain(2.0));
  EXPECT_NEAR(large.standing_base_height_m, 2.0 * one.standing_base_height_m, 1e-6);
  EXPECT_LT((large.standing_joints - one.standing_joints).cwiseAbs().maxCoeff(), 1e-5);
}

}  // namespace
}  // namespace gaitwright
