// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/derive_legs.h"

#include "kinematics/model/body_tree.h"
#include "tests/kinematics/made_robots.h"
#include "tests/kinematics/model/small_urdf.h"
#include "tests/unusual_robots.h"

namespace gaitwright {
namespace {

std::vector<std::string> LegNamesOf(const std::string& urdf, const std::string& yaml = "") {
  const Result<RobotModel> model = LoadRobotFromText(urdf, yaml);
  EXPECT_TRUE(model.ok()) << (model.ok() ? "" : model.failure().message);
  std::vector<std::string> names;
  if (!model.ok()) return names;
  for (const Leg& leg : model->legs) names.push_back(leg.name);
  return names;
}

TEST(DeriveLegs, FrontComesBeforeRearAndLeftBeforeRight) {
  EXPECT_EQ(LegNamesOf(FourLegs()), (std::vector<std::string>{"A_foot", "B_foot", "C_foot", "D_foot"}));
  // The same robot with exchanged names: only positions matter.
  std::string other = Replaced(FourLegs(), "A_", "x_");
  other = Replaced(Replaced(other, "D_", "A_"), "x_", "D_");
  EXPECT_EQ(LegNamesOf(other), (std::vector<std::string>{"D_foot", "B_foot", "C_foot", "A_foot"}));
}

TEST(DeriveLegs, EachLegHasTheFootOfItsIndexAndAMirrorThatHasIt) {
  for (const std::string& urdf : {FourLegs(), unusual::Insect(), unusual::SoledBiped(true, false)}) {
    const Result<RobotModel> model = LoadRobotFromText(urdf, "");
    ASSERT_TRUE(model.ok()) << model.failure().message;
    const std::vector<Pose> X_OB = BodyPoses(*model, model->standing_joints);
    for (std::size_t i = 0; i < model->legs.size(); ++i) {
      const Leg& leg = model->legs[i];
      EXPECT_EQ(leg.foot, static_cast<int>(i));
      EXPECT_EQ(leg.joints.back() + 1, model->feet[i].body);
      ASSERT_GE(leg.mirror, 0);
      const auto mirror = static_cast<std::size_t>(leg.mirror);
      EXPECT_NE(mirror, i);
      EXPECT_EQ(model->legs[mirror].mirror, static_cast<int>(i));
      const auto place = [&](std::size_t f) -> Vector3 {
        return (X_OB[static_cast<std::size_t>(model->feet[f].body)] * model->feet[f].X_BF).translation();
      };
      EXPECT_NEAR(place(i).y(), -place(mirror).y(), 0.1 * model->leg_length_m());
    }
  }
}

TEST(DeriveLegs, ALegOnTheMiddleHasNoMirror) {
  const Result<RobotModel> tripod = LoadRobotFromText(unusual::Tripod(), "");
  ASSERT_TRUE(tripod.ok()) << tripod.failure().message;
  ASSERT_EQ(tripod->legs.size(), 3U);
  int alone = 0;
  for (const Leg& leg : tripod->legs) alone += leg.mirror < 0 ? 1 : 0;
  EXPECT_EQ(alone, 1);
}

TEST(DeriveLegs, NamedFeetAreTheOnlyOnes) {
  EXPECT_EQ(LegNamesOf(FourLegs(), "feet: [{link: D_foot}, {link: A_foot}]"),
            (std::vector<std::string>{"A_foot", "D_foot"}));
  ExpectSays(MessageOf(FourLegs(), "feet: [{link: E_foot}]"), {"'E_foot'"});
}

TEST(DeriveLegs, EndBodiesAreThoseThatComeDownFarthestLowestFirst) {
  const RobotModel four = *LoadRobotFromText(FourLegs(), "");
  std::vector<int> ends = EndBodies(four);
  ASSERT_EQ(ends.size(), 4U);
  for (const int end : ends) {
    for (const Joint& joint : four.joints) EXPECT_NE(joint.parent_body, end) << "an end carries nothing";
  }
  // One shank is 30 % shorter: the leg of 0.42 m ends 0.06 m higher, which is within a quarter.
  std::string shorter = FourLegs();
  shorter.replace(shorter.find("xyz='0 0 -0.2'", shorter.find("B_end")), 14, "xyz='0 0 -0.14'");
  ends = EndBodies(*LoadRobotFromText(shorter, ""));
  ASSERT_EQ(ends.size(), 4U);
  EXPECT_EQ(LoadRobotFromText(shorter, "")->bodies[static_cast<std::size_t>(ends.back())].name[0], 'B');
}

TEST(DeriveLegs, RefusesRobotsWithoutLegsByTheReason) {
  const std::string trunk = SmallLink("trunk", "<box size='0.4 0.2 0.1'/>");
  const Result<RobotModel> still = LoadRobotFromText("<robot name='r'>" + trunk + "</robot>", "");
  ASSERT_FALSE(still.ok());
  EXPECT_EQ(still.failure().code, FailureCode::kNoLegs);
  ExpectSays(still.failure().message, {"0 legs", "no moving joints"});
  const Result<RobotModel> one = LoadRobotFromText(
      "<robot name='r'>" + trunk + SmallLink("a") + PitchJoint("j", "trunk", "a", "0 0 -0.1") + "</robot>", "");
  ASSERT_FALSE(one.ok());
  EXPECT_EQ(one.failure().code, FailureCode::kNoLegs);
  ExpectSays(one.failure().message, {"'j'", "at least two"});
}

}  // namespace
}  // namespace gaitwright
