// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/check_feet.h"

#include <gtest/gtest.h>

#include "tests/kinematics/model/small_urdf.h"

namespace gaitwright {
namespace {

std::string WithFeet(const std::string& feet) { return MessageOf(FourLegs(), "feet: [" + feet + "]"); }

TEST(CheckFeet, NamedFeetAreTheFeet) {
  const Result<RobotModel> model =
      LoadRobotFromText(FourLegs(), "feet: [{link: A_foot}, {link: B_foot}, {link: C_foot}]");
  ASSERT_TRUE(model.ok()) << model.failure().message;
  EXPECT_EQ(model->feet.size(), 3U);
}

TEST(CheckFeet, RefusesFeetWithoutALeg) {
  ExpectSays(WithFeet("{link: trunk}, {link: A_foot}"), {"foot 'trunk'", "on the base", "moving joint"});
  const std::string bumper = Replaced(FourLegs(), "</robot>",
                                      SmallLink("bumper") +
                                          "<joint name='b' type='fixed'><parent link='trunk'/><child "
                                          "link='bumper'/></joint></robot>");
  ExpectSays(MessageOf(bumper, "feet: [{link: A_foot}, {link: bumper}]"), {"foot 'bumper'", "on the base"});
}

TEST(CheckFeet, RefusesTwoFeetOfOneLeg) {
  ExpectSays(WithFeet("{link: A_foot}, {link: A_foot}"), {"'A_foot' is listed twice"});
  ExpectSays(WithFeet("{link: A_foot}, {link: A_shank}"), {"'A_foot' and 'A_shank' are on one body"});
  ExpectSays(WithFeet("{link: A_foot}, {link: A_thigh}"), {"'A_thigh' is on the way to foot 'A_foot'"});
  ExpectSays(WithFeet("{link: A_thigh}, {link: A_foot}"), {"'A_thigh' is on the way to foot 'A_foot'"});
}

TEST(CheckFeet, AFootThatIsNoLinkNamesTheNearest) {
  ExpectSays(WithFeet("{link: A_feet}, {link: B_foot}"), {"no link 'A_feet'", "nearest is 'A_foot'"});
}

}  // namespace
}  // namespace gaitwright
