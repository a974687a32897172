// SPDX-License-Identifier: BSD-3-Clause
#include "planning/tasks/lying.h"

#include <gtest/gtest.h>

#include "kinematics/model/load_robot.h"

namespace gaitwright {
namespace {

class OfFourFeet : public testing::TestWithParam<std::pair<const char*, const char*>> {};
INSTANTIATE_TEST_SUITE_P(Robots, OfFourFeet,
                         testing::Values(std::pair("a1", "trunk"), std::pair("go1", "trunk"),
                                         std::pair("laikago", "trunk"), std::pair("mini_cheetah", "body")),
                         [](const auto& robot) { return std::string(robot.param.first); });

TEST_P(OfFourFeet, ARestIsTheFlatBottomOfItsLink) {
  const RobotModel bare = LoadNamedRobot(GetParam().first).value();
  const Result<RobotModel> model = WithRest(bare, GetParam().second);
  ASSERT_TRUE(model.ok()) << model.failure().message;
  ASSERT_EQ(model->feet.size(), 5U);
  EXPECT_EQ(model->legs.size(), 4U);
  const Foot& rest = model->feet.back();
  EXPECT_EQ(rest.type, FootType::kSole);
  EXPECT_EQ(rest.body, 0);
  EXPECT_GE(rest.sole_F.size(), 4U);
  EXPECT_NE(model->hash, bare.hash);
  // The plan of such a robot contains its texts.
  const RobotModel again = LoadRobotFromText(model->urdf_text, model->yaml_text, model->name, model->meshes).value();
  EXPECT_EQ(again.hash, model->hash);
}

TEST_P(OfFourFeet, LiesAndGetsUp) {
  const RobotModel model = WithRest(LoadNamedRobot(GetParam().first).value(), GetParam().second).value();
  const Result<Lying> lying = FindLying(model, model.standing_joints);
  ASSERT_TRUE(lying.ok()) << lying.failure().message;
  EXPECT_LT(lying->lying.shift.z(), -0.3 * model.leg_length_m());
  EXPECT_GT(lying->over.shift.z(), lying->lying.shift.z());
  PostureKey standing;
  standing.joints = model.standing_joints;
  const PostureMotion up = GetUp(model, standing, *lying, 0.3);
  CheckPostureMotion(model, up);
  ASSERT_EQ(up.sections.size(), 4U);
  EXPECT_EQ(up.sections[0].name, "init");
  EXPECT_EQ(up.sections[1].name, "lift front");
  EXPECT_EQ(up.sections[2].name, "lift rear");
  EXPECT_EQ(up.sections[3].name, "balance");
  EXPECT_EQ(up.keys.back().shift, standing.shift);
  CheckPostureMotion(model, LieDown(model, standing, *lying));
}

TEST(Lying, ARobotWithoutASupportContactIsReported) {
  const RobotModel a1 = LoadNamedRobot("a1").value();
  const Result<Lying> none = FindLying(a1, a1.standing_joints);
  ASSERT_FALSE(none.ok());
  EXPECT_NE(none.failure().message.find("no flat surface"), std::string::npos);
}

TEST(Rests, WhatCannotBeOneIsRefused) {
  const RobotModel a1 = LoadNamedRobot("a1").value();
  const auto why = [&](const std::string& link) {
    const Result<RobotModel> model = WithRest(a1, link);
    return model ? std::string() : model.failure().message;
  };
  EXPECT_NE(why("trnk").find("the nearest is 'trunk'"), std::string::npos) << why("trnk");
  EXPECT_NE(why("FR_foot").find("is a foot or is listed twice"), std::string::npos) << why("FR_foot");
  EXPECT_NE(why("imu_link").find("no flat bottom"), std::string::npos) << why("imu_link");
}

}  // namespace
}  // namespace gaitwright
