// SPDX-License-Identifier: BSD-3-Clause
#include <limits>

#include "kinematics/description/mjcf_write_internal.h"
#include "kinematics/model/body_tree.h"
#include "tests/kinematics/description/mjcf_texts.h"
#include "tests/kinematics/random_state.h"

namespace gaitwright {
namespace {

MjcfJoint HingeOf(const std::string& name, const Vector3& axis, const Vector3& pos) {
  MjcfJoint joint;
  joint.name = name;
  joint.axis = axis;
  joint.pos = pos;
  joint.range = {-1.0, 1.0};
  return joint;
}

/// A base with a leg that has these joints.
MjcfRobot RobotWithLeg(const std::vector<MjcfJoint>& joints) {
  MjcfRobot robot;
  robot.name = "made";
  MjcfBody base, leg;
  base.name = "base";
  leg.name = "leg";
  leg.parent = 0;
  leg.X_PB.translation() = Vector3(0.1, 0.2, 0.3);
  leg.X_PB.linear() = RotationExp({0.3, -0.2, 0.5});
  for (std::size_t j = 0; j < joints.size(); ++j) {
    leg.joints.push_back(static_cast<int>(j));
    robot.tree.body_of.push_back(1);
  }
  robot.tree.bodies = {base, leg};
  robot.tree.joints = joints;
  robot.tree.root = 0;
  robot.tree.in_robot = {true, true};
  robot.couplings.resize(joints.size());
  robot.efforts.assign(joints.size(), 20.0);
  MjcfInertia inertia;
  inertia.mass = 2.0;
  inertia.p_BC = Vector3(0.01, 0.02, -0.1);
  inertia.I_C = Vector3(0.02, 0.03, 0.04).asDiagonal();
  inertia.I_C(0, 1) = inertia.I_C(1, 0) = 0.002;
  robot.inertias = {inertia, inertia};
  robot.collision.resize(2);
  robot.visual.resize(2);
  return robot;
}

RobotModel TreeOfRobot(const MjcfRobot& robot) {
  ConvertedMjcf converted;
  converted.urdf = WriteMjcfUrdf(robot);
  return TreeOf(converted);
}

/// Pose of the leg's body B in the base, at positions of the joints.
Pose PoseOfLeg(const RobotModel& model, const VectorX& positions, const Vector3& last_anchor) {
  const Pose X_OL = BodyPoses(model, positions).back();
  return X_OL * Pose(Eigen::Translation3d(-last_anchor));
}

TEST(MjcfUrdf, AHingeTurnsTheBodyAboutItsAnchor) {
  const Vector3 anchor(0.05, -0.04, 0.2), axis = Vector3(1, 2, -1).normalized();
  const MjcfRobot robot = RobotWithLeg({HingeOf("hip", axis, anchor)});
  const RobotModel model = TreeOfRobot(robot);
  for (const double angle : {0.0, 0.7, -0.4}) {
    const Pose turn =
        Eigen::Translation3d(anchor) * Pose(Eigen::AngleAxisd(angle, axis)) * Eigen::Translation3d(-anchor);
    const Pose X = PoseOfLeg(model, VectorX::Constant(1, angle), anchor);
    EXPECT_LT((X.matrix() - (robot.tree.bodies[1].X_PB * turn).matrix()).norm(), 1e-9) << angle;
  }
}

TEST(MjcfUrdf, AReferencePositionIsTheOneOfTheDrawnPose) {
  MjcfJoint hinge = HingeOf("hip", Vector3::UnitY(), {0, 0, 0.1});
  hinge.ref = 0.4;
  MjcfJoint slide = HingeOf("slide", Vector3::UnitZ(), Vector3::Zero());
  slide.type = MjcfJointType::kSlide;
  slide.ref = -0.2;
  const MjcfRobot robot = RobotWithLeg({hinge, slide});
  const Pose X = PoseOfLeg(TreeOfRobot(robot), Vector2(0.4, -0.2), Vector3::Zero());
  EXPECT_LT((X.matrix() - robot.tree.bodies[1].X_PB.matrix()).norm(), 1e-9);
}

TEST(MjcfUrdf, SeveralJointsAreAChainOfLinksWithoutMass) {
  MjcfRobot robot =
      RobotWithLeg({HingeOf("x", Vector3::UnitX(), Vector3::Zero()), HingeOf("y", Vector3::UnitY(), {0, 0, 0.1}),
                    HingeOf("z", Vector3::UnitZ(), Vector3::Zero())});
  robot.tree.bodies[0].name = "leg_before";  // a name that the chain would use too
  const RobotModel model = TreeOfRobot(robot);
  std::vector<std::string> frames;
  for (const Frame& frame : model.frames) frames.push_back(frame.name);
  EXPECT_EQ(frames, (std::vector<std::string>{"leg_before", "leg_before_2", "leg_before_3", "leg"}));
  EXPECT_EQ(model.dof_names, (std::vector<std::string>{"x", "y", "z"}));
  EXPECT_EQ(model.bodies[1].mass, 0.0);
  EXPECT_EQ(model.total_mass_kg, 4.0);
}

TEST(MjcfUrdf, ALockedJointStandsWhereItIsLocked) {
  MjcfRobot robot =
      RobotWithLeg({HingeOf("a", Vector3::UnitX(), {0, 0.1, 0}), HingeOf("b", Vector3::UnitY(), {0, 0, 0})});
  const Pose X_free = PoseOfLeg(TreeOfRobot(robot), Vector2(0.6, 0.3), Vector3::Zero());
  robot.couplings[0].locked = 0.6;
  const RobotModel one = TreeOfRobot(robot);
  ASSERT_EQ(one.dof_names, std::vector<std::string>{"b"});
  EXPECT_LT((PoseOfLeg(one, VectorX::Constant(1, 0.3), Vector3::Zero()).matrix() - X_free.matrix()).norm(), 1e-9);
  robot.couplings[1].locked = 0.3;
  const RobotModel none = TreeOfRobot(robot);
  ASSERT_EQ(none.num_dofs(), 0);
  EXPECT_LT((none.frames[static_cast<std::size_t>(none.FrameIndex("leg"))].X_BF.matrix() - X_free.matrix()).norm(),
            1e-9);
}

TEST(MjcfUrdf, InertiaAndShapesMoveWithTheAnchor) {
  const Vector3 anchor(0.05, -0.04, 0.2);
  MjcfRobot robot = RobotWithLeg({HingeOf("hip", Vector3::UnitX(), anchor)});
  robot.collision[1].push_back({"sphere", {{"radius", "0.1"}}, Pose(Eigen::Translation3d(0, 0, -0.3))});
  const RobotModel model = TreeOfRobot(robot);
  const Body& leg = model.bodies[1];
  EXPECT_EQ(leg.mass, 2.0);
  EXPECT_LT((leg.p_BC - (robot.inertias[1].p_BC - anchor)).norm(), 1e-12);
  EXPECT_LT((leg.I_C - robot.inertias[1].I_C).norm(), 1e-12);
  ASSERT_EQ(model.collision_shapes.size(), 1U);
  EXPECT_LT((model.collision_shapes[0].X_BS.translation() - (Vector3(0, 0, -0.3) - anchor)).norm(), 1e-12);
  EXPECT_TRUE(model.visual_shapes.empty());
}

TEST(MjcfUrdf, LimitsLossesAndFollowersAreWritten) {
  MjcfJoint lead = HingeOf("lead", Vector3::UnitX(), Vector3::Zero()), turning = lead, slide = lead;
  lead.damping = 0.5;
  lead.friction = 0.25;
  turning.name = "turning";
  turning.range.reset();
  slide.name = "slide";
  slide.type = MjcfJointType::kSlide;
  slide.range.reset();
  MjcfRobot robot = RobotWithLeg({lead, turning, slide});
  robot.efforts = {20.0, std::numeric_limits<double>::infinity(), 0.0};
  robot.couplings[2].leader = 0;
  robot.couplings[2].multiplier = -0.5;
  robot.couplings[2].offset = 0.125;
  const RobotModel model = TreeOfRobot(robot);
  const Joint &first = model.joints[0], &second = model.joints[1], &third = model.joints[2];
  EXPECT_EQ(first.type, JointType::kRevolute);
  EXPECT_EQ(first.lower, -1.0);
  EXPECT_EQ(first.effort_limit, 20.0);
  EXPECT_FALSE(first.effort_limit_is_placeholder);
  EXPECT_TRUE(first.velocity_limit_is_placeholder);
  EXPECT_EQ(first.damping, 0.5);
  EXPECT_EQ(first.friction, 0.25);
  EXPECT_EQ(second.type, JointType::kContinuous);
  EXPECT_TRUE(second.effort_limit_is_placeholder) << "no force limit is an unknown one";
  EXPECT_EQ(third.type, JointType::kPrismatic);
  EXPECT_EQ(third.upper, 1000.0);
  EXPECT_EQ(third.effort_limit, 0.0);
  EXPECT_TRUE(third.is_mimic);
  EXPECT_EQ(third.multiplier, -0.5);
  EXPECT_EQ(third.offset, 0.125);
  EXPECT_EQ(third.dof, 0);
}

TEST(MjcfUrdf, BodiesOfOtherTreesAreNotWritten) {
  MjcfRobot robot = RobotWithLeg({HingeOf("hip", Vector3::UnitX(), Vector3::Zero())});
  MjcfBody box;
  box.name = "box";
  robot.tree.bodies.push_back(box);
  robot.tree.in_robot.push_back(false);
  robot.inertias.push_back(robot.inertias[0]);
  robot.collision.resize(3);
  robot.visual.resize(3);
  EXPECT_EQ(TreeOfRobot(robot).frames.size(), 2U);
  EXPECT_EQ(WriteMjcfUrdf(robot).find("box"), std::string::npos);
}

}  // namespace
}  // namespace gaitwright
