// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/leg_plane.h"

#include <gtest/gtest.h>

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/model/load_robot.h"
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
    // The slide stands where it can go both ways.
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
    // As far out as below, and away from the body.
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

/// Twice the size stands twice as high.
TEST(StandingPosture, ScalesWithTheRobot) {
  const RobotModel one = Loaded(unusual::Plain()), large = Loaded(unusual::Plain(2.0));
  EXPECT_NEAR(large.standing_base_height_m, 2.0 * one.standing_base_height_m, 1e-6);
  EXPECT_LT((large.standing_joints - one.standing_joints).cwiseAbs().maxCoeff(), 1e-5);
}

}  // namespace
}  // namespace gaitwright
