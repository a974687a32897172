// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/description/mjcf_model_internal.h"
#include "tests/kinematics/description/mjcf_texts.h"

namespace gaitwright {
namespace {

const MjcfFiles kNoMjcfFiles;

/// The context of a model with its tree. The text is the content of <worldbody>.
struct TreeOfText {
  explicit TreeOfText(const std::string& world, const std::string& sections = "")
      : context("<mujoco>" + sections + "<worldbody>" + world + "</worldbody></mujoco>", kNoMjcfFiles, "model.xml"),
        tree(ReadMjcfTree(context)) {}

  MjcfContext context;
  MjcfTree tree;
};

FailureCode CodeOfTree(const std::string& world) {
  return MjcfFailureOf([&] { TreeOfText made(world); }).code;
}

TEST(MjcfTree, BodiesAndJointsAreInMuJoCosOrder) {
  const TreeOfText made(
      "<body name='a'><freejoint name='f'/><body name='b'><joint name='b1'/><joint name='b2' type='slide'/>"
      "<body name='c'><joint name='c1' type='ball'/></body></body><body name='d'><joint name='d1'/></body></body>");
  std::vector<std::string> bodies, joints;
  std::vector<int> parents;
  for (const MjcfBody& body : made.tree.bodies) {
    bodies.push_back(body.name);
    parents.push_back(body.parent);
  }
  for (const MjcfJoint& joint : made.tree.joints) joints.push_back(joint.name);
  EXPECT_EQ(bodies, (std::vector<std::string>{"a", "b", "c", "d"}));
  EXPECT_EQ(parents, (std::vector<int>{-1, 0, 1, 0}));
  EXPECT_EQ(joints, (std::vector<std::string>{"f", "b1", "b2", "c1", "d1"}));
  EXPECT_EQ(made.tree.body_of, (std::vector<int>{0, 1, 1, 2, 3}));
  EXPECT_EQ(made.tree.bodies[1].joints, (std::vector<int>{1, 2}));
  EXPECT_EQ(made.tree.joint_named.at("c1"), 3);
  EXPECT_EQ(made.tree.body_named.at("d"), 3);
  std::vector<std::size_t> positions;
  for (const MjcfJoint& joint : made.tree.joints) positions.push_back(joint.num_positions());
  EXPECT_EQ(positions, (std::vector<std::size_t>{7, 1, 1, 4, 1}));
  EXPECT_FALSE(made.tree.joints[3].is_scalar());
}

TEST(MjcfTree, TheRobotIsTheLargestTreeAndOnlyItsInnerJointsMove) {
  const TreeOfText made(
      "<body name='box'><joint name='lid'/></body>"
      "<body name='base'><freejoint name='free'/><body name='leg'><joint name='hip'/></body></body>"
      "<body name='other'><freejoint/><body name='part'><joint name='k'/></body></body>");
  EXPECT_EQ(made.tree.bodies[static_cast<std::size_t>(made.tree.root)].name, "base") << "of equal ones the first";
  EXPECT_EQ(made.tree.in_robot, (std::vector<bool>{false, true, true, false, false}));
  const auto index = [&](const char* name) { return made.tree.joint_named.at(name); };
  EXPECT_TRUE(made.tree.Moves(index("hip")));
  EXPECT_FALSE(made.tree.Moves(index("free")));
  EXPECT_TRUE(made.tree.IsRobotJoint(index("free")));
  EXPECT_FALSE(made.tree.IsRobotJoint(index("lid")));
  EXPECT_FALSE(made.tree.Moves(index("k")));
  EXPECT_EQ(made.context.notes.size(), 2U) << "one for each body that is left out";
}

TEST(MjcfTree, FramesMoveBodiesJointsAndGeomsAlike) {
  const TreeOfText made(
      "<frame pos='1 0 0' euler='0 0 90'><body name='a' pos='1 0 0'><freejoint/><body name='b'>"
      "<frame pos='0 0 1' axisangle='0 0 1 90'><joint name='j' pos='1 0 0' axis='1 0 0'/><geom size='1'/></frame>"
      "</body></body></frame>");
  EXPECT_LT((made.tree.bodies[0].X_PB.translation() - Vector3(1, 1, 0)).norm(), 1e-12);
  EXPECT_LT((made.tree.bodies[0].X_PB.linear().col(0) - Vector3::UnitY()).norm(), 1e-12);
  const MjcfJoint& joint = made.tree.joints.back();
  EXPECT_LT((joint.pos - Vector3(0, 1, 1)).norm(), 1e-12);
  EXPECT_LT((joint.axis - Vector3::UnitY()).norm(), 1e-12);
  ASSERT_EQ(made.tree.bodies[1].geoms.size(), 1U);
  EXPECT_LT((made.tree.bodies[1].geoms[0].X_BF.translation() - Vector3::UnitZ()).norm(), 1e-12);
}

TEST(MjcfTree, NamesAreMadeThatNobodyHas) {
  const TreeOfText made(
      "<body><freejoint/><body name='body_1'><joint/><joint/></body><body><joint name='body_3_joint'/><joint/></body>"
      "</body>");
  std::vector<std::string> names;
  for (const MjcfBody& body : made.tree.bodies) names.push_back(body.name);
  for (const MjcfJoint& joint : made.tree.joints) names.push_back(joint.name);
  EXPECT_EQ(names, (std::vector<std::string>{"body_1_2", "body_1", "body_3", "body_1_2_joint", "body_1_joint",
                                             "body_1_joint_2", "body_3_joint", "body_3_joint_2"}));
}

TEST(MjcfTree, SitesKnowTheirBody) {
  const TreeOfText made(
      "<site name='w'/><body name='a'><site name='s'/><body name='b'><frame><site name='t'/></frame>"
      "</body></body>");
  EXPECT_EQ(made.tree.body_of_site, (std::map<std::string, int>{{"s", 0}, {"t", 1}, {"w", -1}}));
}

TEST(MjcfTree, ClassesOfABodyHoldForWhatStandsInIt) {
  const TreeOfText made(
      "<body name='a' childclass='stiff'><freejoint/><body name='b'><joint name='b1'/><frame childclass='soft'>"
      "<joint name='b2'/></frame><joint name='b3' class='soft'/></body></body>",
      "<default><default class='stiff'><joint damping='5'/></default><default class='soft'><joint damping='1'/>"
      "</default></default>");
  std::vector<double> damping;
  for (const MjcfJoint& joint : made.tree.joints) damping.push_back(joint.damping);
  EXPECT_EQ(damping, (std::vector<double>{0.0, 5.0, 1.0, 1.0}));
}

TEST(MjcfTree, RefusesByCode) {
  EXPECT_EQ(CodeOfTree(""), FailureCode::kMjcfBodies);
  EXPECT_EQ(CodeOfTree("<joint/>"), FailureCode::kMjcfElement);
  EXPECT_EQ(CodeOfTree("<frame><inertial/></frame>"), FailureCode::kMjcfElement);
  EXPECT_EQ(CodeOfTree("<body name='world'/>"), FailureCode::kDoubleName);
  EXPECT_EQ(CodeOfTree("<body name='a'/><body name='a'/>"), FailureCode::kDoubleName);
  EXPECT_EQ(CodeOfTree("<body><joint name='j'/></body><body><joint name='j'/></body>"), FailureCode::kDoubleName);
  EXPECT_EQ(CodeOfTree("<body><body><freejoint/></body></body>"), FailureCode::kMjcfJoint);
  EXPECT_EQ(CodeOfTree("<body><freejoint/><joint/></body>"), FailureCode::kMjcfJoint);
  EXPECT_EQ(CodeOfTree("<body><inertial/><frame><inertial/></frame></body>"), FailureCode::kMjcfElement);
  EXPECT_EQ(CodeOfTree("<body><replicate count='2'/></body>"), FailureCode::kMjcfElement);
  EXPECT_EQ(CodeOfTree("<replicate><frame><body/></frame></replicate><body/>"), FailureCode::kMjcfElement);
}

}  // namespace
}  // namespace gaitwright
