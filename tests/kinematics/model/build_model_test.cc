// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/build_model.h"

#include "kinematics/model/body_tree.h"
#include "kinematics/spatial/rotation.h"
#include "tests/kinematics/model/small_urdf.h"

namespace gaitwright {
namespace {

Result<RobotModel> Built(const std::string& inside, double scale = 1.0, bool strict = false) {
  return BuildModel(SplitUrdf("<robot name='r'>" + inside + "</robot>", scale), "made", scale, strict);
}

RobotModel BuiltOrFail(const std::string& inside, double scale = 1.0) {
  Result<RobotModel> model = Built(inside, scale);
  EXPECT_TRUE(model.ok()) << (model.ok() ? "" : model.failure().message);
  return model.ok() ? *model : RobotModel();
}

std::string MassLink(const std::string& name, double mass, const std::string& xyz,
                     const std::string& moments = "1 1 1") {
  const std::string i = moments.substr(0, moments.find(' '));
  const std::size_t second = moments.find(' ') + 1, third = moments.rfind(' ') + 1;
  return "<link name='" + name + "'><inertial><origin xyz='" + xyz + "'/><mass value='" + std::to_string(mass) +
         "'/><inertia ixx='" + i + "' iyy='" + moments.substr(second, third - second - 1) + "' izz='" +
         moments.substr(third) + "' ixy='0' ixz='0' iyz='0'/></inertial></link>";
}

std::string BuiltJoint(const std::string& name, const std::string& type, const std::string& parent,
                       const std::string& child,
                       const std::string& rest = "<limit lower='-1' upper='2' effort='5' velocity='6'/>") {
  return "<joint name='" + name + "' type='" + type + "'><parent link='" + parent + "'/><child link='" + child + "'/>" +
         rest + "</joint>";
}

TEST(BuildModel, FixedLinksAreMergedByTheLawOfParallelAxes) {
  const RobotModel model = BuiltOrFail(MassLink("a", 1.0, "0 0 0") + MassLink("b", 3.0, "0 0 0") +
                                       BuiltJoint("f", "fixed", "a", "b", "<origin xyz='0 0 2'/>"));
  ASSERT_EQ(model.bodies.size(), 1U);
  const Body& body = model.bodies[0];
  EXPECT_EQ(body.name, "b") << "the heaviest link";
  EXPECT_NEAR(body.mass, 4.0, 1e-12);
  EXPECT_LT((body.p_BC - Vector3(0, 0, 1.5)).norm(), 1e-12);
  // Two points of 1 and 3 kg at a distance of 2 m: the reduced mass 3/4 times 4.
  EXPECT_LT((body.I_C - Vector3(5, 5, 2).asDiagonal().toDenseMatrix()).norm(), 1e-12);
  ASSERT_EQ(model.frames.size(), 2U);
  EXPECT_EQ(model.frames[1].name, "b");
  EXPECT_LT((model.frames[1].X_BF.translation() - Vector3(0, 0, 2)).norm(), 1e-12);
}

TEST(BuildModel, AnInertiaInTurnedAxesIsTurnedBack) {
  const std::string turned =
      "<link name='a'><inertial><origin xyz='1 0 0' rpy='0 0 1.5707963267948966'/><mass value='1'/><inertia ixx='1' "
      "iyy='2' izz='2.5' ixy='0' ixz='0' iyz='0'/></inertial></link>";
  const Body body = BuiltOrFail(turned).bodies[0];
  EXPECT_LT((body.I_C - Vector3(2, 1, 2.5).asDiagonal().toDenseMatrix()).norm(), 1e-9);
}

TEST(BuildModel, JointsAreInAnOrderWithParentsFirstWhateverTheFileHas) {
  const std::string links = MassLink("c", 1, "0 0 0") + MassLink("a", 1, "0 0 0") + MassLink("b", 1, "0 0 0");
  const RobotModel model =
      BuiltOrFail(links + BuiltJoint("second", "revolute", "b", "c") + BuiltJoint("first", "prismatic", "a", "b"));
  ASSERT_EQ(model.dof_names, (std::vector<std::string>{"first", "second"}));
  EXPECT_EQ(model.joints[0].type, JointType::kPrismatic);
  EXPECT_EQ(model.joints[1].parent_body, 1);
  for (std::size_t j = 0; j < model.joints.size(); ++j) EXPECT_LE(model.joints[j].parent_body, static_cast<int>(j));
}

TEST(BuildModel, AScaleStretchesLengthsAndStrokesAndLeavesMasses) {
  const std::string text = MassLink("a", 2, "0 0 1") + MassLink("b", 1, "0 0 0") + MassLink("c", 1, "0 0 0") +
                           BuiltJoint("slide", "prismatic", "a", "b",
                                      "<origin xyz='1 2 3'/><limit lower='-1' upper='2' effort='5' velocity='6'/>") +
                           BuiltJoint("turn", "revolute", "b", "c");
  const RobotModel one = BuiltOrFail(text), half = BuiltOrFail(text, 0.5);
  EXPECT_EQ(half.joints[0].X_PJ.translation(), Vector3(0.5, 1.0, 1.5));
  EXPECT_EQ(half.joints[0].lower, -0.5);
  EXPECT_EQ(half.joints[0].upper, 1.0);
  EXPECT_EQ(half.joints[1].upper, 2.0) << "angles stay";
  EXPECT_EQ(half.bodies[0].p_BC, 0.5 * one.bodies[0].p_BC);
  EXPECT_EQ(half.total_mass_kg, one.total_mass_kg);
  EXPECT_EQ(half.bodies[0].I_C, one.bodies[0].I_C);
}

TEST(BuildModel, AFollowerOfAFollowerHasTheProductOfTheirGears) {
  std::string links, joints;
  for (const char* name : {"a", "b", "c", "d"}) links += MassLink(name, 1, "0 0 0");
  const std::string limit = "<limit lower='-1' upper='2' effort='5' velocity='6'/>";
  joints += BuiltJoint("third", "revolute", "c", "d", limit + "<mimic joint='second' multiplier='3' offset='0.5'/>");
  joints += BuiltJoint("second", "revolute", "b", "c", limit + "<mimic joint='first' multiplier='-2' offset='0.25'/>");
  joints += BuiltJoint("first", "revolute", "a", "b");
  const RobotModel model = BuiltOrFail(links + joints);
  ASSERT_EQ(model.dof_names, std::vector<std::string>{"first"});
  const Joint& third = model.joints[2];
  EXPECT_EQ(third.name, "third");
  EXPECT_EQ(third.multiplier, -6.0);
  EXPECT_EQ(third.offset, 3.0 * 0.25 + 0.5);
  const Result<RobotModel> absurd = Built(links + Replaced(Replaced(joints, "'3'", "'3e3'"), "'-2'", "'1e4'"));
  ASSERT_FALSE(absurd.ok());
  EXPECT_EQ(absurd.failure().code, FailureCode::kBadMimic);
}

TEST(BuildModel, LimitsThatNoJointHasArePlaceholders) {
  const auto joint = [](const std::string& limit) {
    return BuiltOrFail(MassLink("a", 1, "0 0 0") + MassLink("b", 1, "0 0 0") +
                       BuiltJoint("j", "continuous", "a", "b", limit))
        .joints.at(0);
  };
  const Joint known = joint("<limit effort='5' velocity='6'/>");
  EXPECT_FALSE(known.effort_limit_is_placeholder || known.velocity_limit_is_placeholder);
  EXPECT_TRUE(std::isinf(known.lower) && std::isinf(known.upper));
  const Joint no_speed = joint("<limit effort='5' velocity='0'/>");
  EXPECT_TRUE(!no_speed.effort_limit_is_placeholder && no_speed.velocity_limit_is_placeholder);
  for (const char* limit : {"<limit effort='0' velocity='6'/>", "<limit effort='1000' velocity='6'/>", ""}) {
    const Joint unknown = joint(limit);
    EXPECT_TRUE(unknown.effort_limit_is_placeholder && unknown.velocity_limit_is_placeholder) << limit;
  }
}

TEST(BuildModel, ALinkWithoutInertiaEndsInAFixedJointOrIsRefusedStrictly) {
  const std::string text = MassLink("a", 1, "0 0 0") + "<link name='b'/>" + BuiltJoint("idle", "revolute", "a", "b");
  const RobotModel model = BuiltOrFail(text);
  EXPECT_EQ(model.num_dofs(), 0);
  EXPECT_EQ(model.frames.size(), 2U);
  ASSERT_EQ(model.findings.size(), 1U);
  EXPECT_EQ(model.findings[0].code, FailureCode::kNoInertia);
  EXPECT_EQ(PartText(model.findings[0].part), "joint 'idle'");
  const Result<RobotModel> strict = Built(text, 1.0, true);
  ASSERT_FALSE(strict.ok());
  EXPECT_EQ(strict.failure().code, FailureCode::kNoInertia);
}

TEST(BuildModel, RefusesWhatIsNoTreeOrHasNoMass) {
  const Result<RobotModel> light = Built("<link name='a'/>");
  ASSERT_FALSE(light.ok());
  EXPECT_EQ(light.failure().code, FailureCode::kNoMass);
  const Result<RobotModel> loop = Built(MassLink("a", 1, "0 0 0") + MassLink("b", 1, "0 0 0") +
                                        BuiltJoint("x", "fixed", "a", "b") + BuiltJoint("y", "fixed", "b", "a"));
  ASSERT_FALSE(loop.ok());
  EXPECT_EQ(loop.failure().code, FailureCode::kNotUrdf);
}

TEST(InertiasUsed, AreThoseThatThePlaceholdersOfAFileStandFor) {
  std::string text = "<robot name='r'>" + SmallLink("a", "<box size='0.1 0.2 0.3'/>");
  text += Replaced(SmallLink("b", "<box size='0.1 0.2 0.3'/>"), "mass value='1'", "mass value='3'");
  text += SmallLink("c", "<box size='0.1 0.2 0.3'/>") + BuiltJoint("x", "revolute", "a", "b") +
          BuiltJoint("y", "revolute", "a", "c") + "</robot>";
  const std::vector<LinkInertia> used = InertiasUsed(SplitUrdf(text, 1.0), 1.0);
  ASSERT_EQ(used.size(), 3U);
  const Matrix3 solid = (Vector3(0.13, 0.10, 0.05) / 12.0).asDiagonal();
  for (const LinkInertia& inertia : used)
    EXPECT_LT((inertia.I - (inertia.link == "b" ? 3.0 : 1.0) * solid).norm(), 1e-9) << inertia.link;
  EXPECT_TRUE(InertiasUsed(SplitUrdf(Replaced(text, "value='3'", "value='1'"), 1.0), 1.0).empty())
      << "links of one mass may have one inertia";
}

}  // namespace
}  // namespace gaitwright
