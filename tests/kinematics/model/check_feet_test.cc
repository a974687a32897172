// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/check_feet.h"

#include <gtest/gtest.h>

#include <algorithm>

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
  ExpectSays(WithFeet("{link: trunk}, {link: A_foot}"), {"foot 'trunk'", "fixed to the base", "moving joint"});
  const std::string bumper = Replaced(FourLegs(), "</robot>",
                                      SmallLink("bumper") +
                                          "<joint name='b' type='fixed'><parent link='trunk'/><child "
                                          "link='bumper'/></joint></robot>");
  ExpectSays(MessageOf(bumper, "feet: [{link: A_foot}, {link: bumper}]"), {"foot 'bumper'", "fixed to the base"});
}

TEST(CheckFeet, RefusesTwoFeetOfOneLeg) {
  ExpectSays(WithFeet("{link: A_foot}, {link: A_foot}"), {"'A_foot' is listed twice"});
  ExpectSays(WithFeet("{link: A_foot}, {link: A_shank}"), {"'A_foot' and 'A_shank' are on one body"});
  ExpectSays(WithFeet("{link: A_foot}, {link: A_thigh}"), {"'A_thigh' is on the chain to foot 'A_foot'"});
  ExpectSays(WithFeet("{link: A_thigh}, {link: A_foot}"), {"'A_thigh' is on the chain to foot 'A_foot'"});
}

TEST(CheckFeet, AFootThatIsNoLinkNamesTheNearest) {
  ExpectSays(WithFeet("{link: A_feet}, {link: B_foot}"), {"no link 'A_feet'", "nearest is 'A_foot'"});
}

/// Four legs whose shanks end in missing meshes.
std::string WithoutMeshes() { return FourLegs("<mesh filename='gone.stl'/>"); }

/// WithoutMeshes with a link without shape 0.02 m below each foot, which marks the contact.
std::string WithContactLinks() {
  std::string links;
  for (const std::string leg : {"A", "B", "C", "D"}) {
    links += "<link name='" + leg + "_tip'/><joint name='" + leg + "_tip_joint' type='fixed'><parent link='" + leg +
             "_foot'/><child link='" + leg + "_tip'/><origin xyz='0 0 -0.02'/></joint>";
  }
  return Replaced(WithoutMeshes(), "</robot>", links + "</robot>");
}

TEST(CheckFeet, ALinkAtTheContactTellsAFootWhoseMeshIsMissing) {
  const Result<RobotModel> refused = LoadRobotFromText(WithoutMeshes(), "");
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.failure().code, FailureCode::kUnknownFoot);
  const Result<RobotModel> model = LoadRobotFromText(WithContactLinks(), "");
  ASSERT_TRUE(model.ok()) << model.failure().message;
  ASSERT_EQ(model->feet.size(), 4U);
  for (const Foot& foot : model->feet) {
    EXPECT_EQ(foot.type, FootType::kPoint);
    EXPECT_TRUE(foot.link.ends_with("_tip")) << foot.link;
  }
  const auto warned = std::count_if(model->findings.begin(), model->findings.end(), [](const Finding& f) {
    return f.code == FailureCode::kMissingMesh && f.level == FindingLevel::kWarning;
  });
  EXPECT_EQ(warned, 4);
}

TEST(CheckFeet, AShapeAboveAMissingMeshIsWarnedOf) {
  const std::string urdf = Replaced(WithoutMeshes(), "_shank'><inertial>",
                                    "_shank'><collision><origin xyz='0 0 -0.1'/><geometry><box size='0.02 0.02 0.16'/>"
                                    "</geometry></collision><inertial>");
  const Result<RobotModel> model = LoadRobotFromText(urdf, "");
  ASSERT_TRUE(model.ok()) << model.failure().message;
  EXPECT_EQ(std::count_if(model->findings.begin(), model->findings.end(),
                          [](const Finding& f) { return f.code == FailureCode::kMissingMesh; }),
            4);
}

}  // namespace
}  // namespace gaitwright
