// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/urdf_check.h"

#include <gtest/gtest.h>

#include "kinematics/model/build_model.h"
#include "tests/kinematics/model/small_urdf.h"

namespace gaitwright {
namespace {

std::string With(const std::string& from, const std::string& to) { return MessageOf(Replaced(FourLegs(), from, to)); }

TEST(UrdfCheck, TheSmallRobotItselfIsGood) {
  const Result<RobotModel> model = LoadRobotFromText(FourLegs(), "");
  ASSERT_TRUE(model.ok()) << model.failure().message;
  EXPECT_EQ(model->num_dofs(), 8);
  EXPECT_EQ(model->legs.size(), 4U);
}

TEST(UrdfCheck, AXacroFileIsDistinguishedFromAUrdf) {
  ExpectSays(MessageOf("<robot name='r'>\n<xacro:macro name='leg'><link name='a'/></xacro:macro></robot>"),
             {"line 2 has <xacro:macro>", "expand it first"});
}

TEST(UrdfCheck, RefusesMimicsThatCannotBeAndNamesTheJoint) {
  const auto with = [](const std::string& mimic) { return MessageOf(FourLegsWhere("A", "<mimic " + mimic + "/>")); };
  ExpectSays(with("joint='A_knee'"), {"joint 'A_knee'", "mimics itself"});
  ExpectSays(with("joint='B_end'"), {"joint 'A_knee'", "'B_end', which is fixed"});
  ExpectSays(with("joint='B_kneee'"), {"joint 'A_knee'", "'B_kneee', which is not a joint", "nearest is 'B_knee'"});
  ExpectSays(with("joint='B_knee' multiplier='0'"), {"joint 'A_knee'", "multiplier 0"});
  ExpectSays(with("joint='B_knee' multiplier='nan'"), {"joint 'A_knee'", "multiplier", "not a finite number"});
  ExpectSays(with("joint='B_knee' offset='inf'"), {"joint 'A_knee'", "offset", "not a finite number"});
  std::string circle = Replaced(FourLegs(), "<!--A_extra-->", "<mimic joint='B_knee'/>");
  circle = Replaced(circle, "<!--B_extra-->", "<mimic joint='C_knee'/>");
  EXPECT_EQ(MessageOf(circle), "");
  circle = Replaced(circle, "<!--C_extra-->", "<mimic joint='B_knee'/>");
  ExpectSays(MessageOf(circle), {"'A_knee' mimics 'B_knee', which mimics 'C_knee', which mimics 'B_knee'", "a cycle"});
}

/// The part that a refusal is about.
std::optional<RobotPart> PartOf(const std::string& urdf, bool strict = false) {
  const std::optional<Failure> failure = CheckUrdf(urdf, strict);
  if (!failure) throw InvalidArgument("the URDF is accepted");
  return failure->part;
}

TEST(UrdfCheck, ARefusalCarriesItsPart) {
  const auto where = [](const std::string& from, const std::string& to) {
    return PartOf(Replaced(FourLegs(), from, to));
  };
  EXPECT_EQ(where("mass value='1'", "mass value='1e7'"), (RobotPart{PartKind::kLink, "trunk"}));
  EXPECT_EQ(where("damping='0.1'", "damping='nan'"), (RobotPart{PartKind::kJoint, "A_hip"}));
  EXPECT_EQ(where("name='A_hip' type='revolute'", "name='A_hip'"), (RobotPart{PartKind::kJoint, "A_hip"}));
  EXPECT_EQ(where("name='B_hip'", "name='A_hip'"), (RobotPart{PartKind::kJoint, "A_hip"}));
  EXPECT_EQ(PartOf(FourLegsWhere("A", "<mimic joint='A_knee'/>")), (RobotPart{PartKind::kJoint, "A_knee"}));
  const std::string second = PitchJoint("second", "B_thigh", "A_shank", "0 0 0");
  EXPECT_EQ(where("</robot>", second + "</robot>"), (RobotPart{PartKind::kLink, "A_shank"}));
  EXPECT_EQ(PartOf("<robot name='r'/>"), std::nullopt);
  EXPECT_EQ(where("</robot>", SmallLink("other") + "</robot>"), std::nullopt) << "two roots are no part";
}

TEST(RobotPart, ItsTextNamesKindAndName) {
  EXPECT_EQ(PartText({}), "robot");
  EXPECT_EQ(PartText({PartKind::kLink, "trunk"}), "link 'trunk'");
  EXPECT_EQ(PartText({PartKind::kJoint, ""}), "joint ''");
}

TEST(UrdfCheck, AChainOfMimicsMovesAsItsProduct) {
  // A = 2 B + 0.1, B = -C + 0.2, C = 0.5 D - 0.3, with the chain against the order of the joints.
  std::string urdf = Replaced(FourLegs(), "<!--A_extra-->", "<mimic joint='B_knee' multiplier='2' offset='0.1'/>");
  urdf = Replaced(urdf, "<!--B_extra-->", "<mimic joint='C_knee' multiplier='-1' offset='0.2'/>");
  urdf = Replaced(urdf, "<!--C_extra-->", "<mimic joint='D_knee' multiplier='0.5' offset='-0.3'/>");
  for (const bool backwards : {false, true}) {
    std::string text = urdf;
    if (backwards) {  // A mimics none, B mimics A and so on
      text = FourLegs();
      text = Replaced(text, "<!--D_extra-->", "<mimic joint='C_knee' multiplier='2' offset='0.1'/>");
      text = Replaced(text, "<!--C_extra-->", "<mimic joint='B_knee' multiplier='-1' offset='0.2'/>");
      text = Replaced(text, "<!--B_extra-->", "<mimic joint='A_knee' multiplier='0.5' offset='-0.3'/>");
    }
    const Result<RobotModel> model = BuildModel(SplitUrdf(text, 1.0), "chain", 1.0);
    ASSERT_TRUE(model.ok()) << model.failure().message;
    EXPECT_EQ(model->num_dofs(), 5);
    const double lead = 0.7;
    const double third = 0.5 * lead - 0.3, second = -third + 0.2, first = 2.0 * second + 0.1;
    for (const Joint& joint : model->joints) {
      if (joint.name != (backwards ? "D_knee" : "A_knee")) continue;
      EXPECT_EQ(joint.dof, model->DofIndex(backwards ? "A_knee" : "D_knee"));
      EXPECT_NEAR(joint.multiplier * lead + joint.offset, first, 1e-12);
    }
  }
}

TEST(UrdfCheck, StrictlyRefusesLimitsThatAreLeftOut) {
  const auto strictly = [](const std::string& from) { return MessageOf(Replaced(FourLegs(), from, ""), "", true); };
  ExpectSays(strictly(" lower='-2' upper='1'"), {"joint 'A_hip'", "'lower'", "reads as 0"});
  ExpectSays(strictly(" lower='-2'"), {"joint 'A_hip'", "'lower'"});
  ExpectSays(strictly(" upper='1'"), {"joint 'A_hip'", "'upper'"});
  EXPECT_EQ(With("'revolute'", "'continuous'"), "");
  EXPECT_EQ(MessageOf(Replaced(Replaced(FourLegs(), "'revolute'", "'continuous'"), " lower='-2' upper='1'", "")), "");
}

TEST(UrdfCheck, RefusesNumbersThatAreNoneOrAbsurdByName) {
  ExpectSays(With("mass value='1'", "mass value='1e7'"), {"link 'trunk'", "1e7 is too large"});
  ExpectSays(With("ixx='0.01'", "ixx='1e300'"), {"link 'trunk'", "ixx", "too large"});
  ExpectSays(With("0 0 -0.2", "0 0 -2e5"), {"joint 'A_knee'", "too large"});
  ExpectSays(With("sphere radius='0.02'", "sphere radius='inf'"), {"link 'A_foot'", "'inf' is not a finite number"});
  ExpectSays(With("damping='0.1'", "damping='nan'"), {"joint 'A_hip'", "damping", "not a finite number"});
  ExpectSays(With("damping='0.1'", "damping='-3'"), {"joint 'A_hip'", "damping is -3"});
  ExpectSays(With("effort='30'", "effort='-30'"), {"joint 'A_hip'", "its effort limit is -30"});
  ExpectSays(With("damping='0.1'", "friction='-3'"), {"joint 'A_hip'", "friction is -3"});
  ExpectSays(MessageOf(FourLegsWhere("C", "<safety_controller k_velocity='inf'/>")), {"joint 'C_knee'", "k_velocity"});
  ExpectSays(With("mass value='1'", "mass value='0'"), {"robot 'robot'", "total mass of 0 kg"});
}

TEST(UrdfCheck, UrdfdomsOwnReasonIsGivenAndNothingPrinted) {
  testing::internal::CaptureStderr();
  const std::string message = MessageOf(FourLegsWhere("A", "<safety_controller soft_lower_limit='0'/>"));
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  ExpectSays(message, {"k_velocity"});
}

TEST(UrdfCheck, CapsulesAreRead) {
  const Result<RobotModel> model = LoadRobotFromText(FourLegs("<capsule radius='0.02' length='0.1'/>"), "");
  ASSERT_TRUE(model.ok()) << model.failure().message;
  ASSERT_EQ(model->collision_shapes.size(), 5U);
  EXPECT_EQ(model->collision_shapes[1].type, ShapeType::kCapsule);
  EXPECT_EQ(model->collision_shapes[1].link, "A_foot");
  EXPECT_EQ(model->collision_shapes[1].size, Vector3(0.02, 0.1, 0.0));
  // The foot reaches 0.2 + 0.05 + 0.02 m below the knee and rolls on its round end.
  EXPECT_EQ(model->feet[0].type, FootType::kSphere);
  EXPECT_DOUBLE_EQ(model->feet[0].radius, 0.02);
  EXPECT_NEAR(model->feet[0].X_BF.translation().z(), -0.25, 1e-12);
}

}  // namespace
}  // namespace gaitwright
