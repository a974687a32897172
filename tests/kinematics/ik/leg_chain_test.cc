// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/ik/leg_chain.h"

#include "kinematics/base/result.h"
#include "kinematics/dynamics/dynamics.h"
#include "tests/kinematics/made_robots.h"

namespace gaitwright {
namespace {

class LegChainTest : public testing::TestWithParam<const char*> {};

/// Coordinates of a leg from a configuration.
VectorX CoordinatesOf(const LegChain& chain, const VectorX& q) {
  VectorX coordinates(chain.num_coordinates());
  for (Eigen::Index c = 0; c < coordinates.size(); ++c) coordinates[c] = q[7 + chain.dofs[static_cast<std::size_t>(c)]];
  return coordinates;
}

TEST_P(LegChainTest, TheFootIsWhereTheRobotsKinematicsHasIt) {
  const RobotModel model = AnyRobot(GetParam());
  RandomState random(11);
  DynamicsScratch scratch(model);
  for (int leg = 0; leg < static_cast<int>(model.legs.size()); ++leg) {
    const LegChain chain(model, leg);
    const Foot& foot = model.feet[static_cast<std::size_t>(leg)];
    for (int i = 0; i < 5; ++i) {
      const VectorX q = random.Configuration(model);
      ForwardKinematics(model, q, scratch);
      const Pose X_BF = FramePose(scratch, 0, Pose::Identity()).inverse() * FramePose(scratch, foot.body, foot.X_BF);
      EXPECT_LT((chain.FootPose(CoordinatesOf(chain, q)).matrix() - X_BF.matrix()).norm(), 1e-12);
    }
  }
}

TEST_P(LegChainTest, TheJacobianIsTheDifferenceQuotient) {
  constexpr double kStep = 1e-6;
  const LegChain chain(AnyRobot(GetParam()), 0);
  RandomState random(13);
  LegChain::Jacobian screws(6, static_cast<Eigen::Index>(chain.links.size())), J(6, chain.num_coordinates());
  for (int i = 0; i < 5; ++i) {
    const VectorX x = random.Vector(chain.num_coordinates());
    const Pose X = chain.FootPose(x, screws, J);
    EXPECT_LT((X.matrix() - chain.FootPose(x).matrix()).norm(), 1e-12);
    for (Eigen::Index c = 0; c < x.size(); ++c) {
      const VectorX step = kStep * VectorX::Unit(x.size(), c);
      const Pose before = chain.FootPose(x - step), after = chain.FootPose(x + step);
      const Vector3 v = (after.translation() - before.translation()) / (2.0 * kStep);
      const Vector3 w_F = RotationLog(before.linear().transpose() * after.linear()) / (2.0 * kStep);
      EXPECT_GT(v.norm() + w_F.norm(), 1e-3);
      EXPECT_LT((J.col(c).head<3>() - v).norm(), 1e-8) << c;
      EXPECT_LT((J.col(c).tail<3>() - w_F).norm(), 1e-8) << c;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(AnyRobots, LegChainTest, testing::ValuesIn(kAnyRobots),
                         [](const auto& given) { return std::string(given.param); });

TEST(LegChain, ATurnOfTheLastJointTurnsTheFootAlone) {
  const LegChain chain(Made(SixJoints()), 0);
  VectorX x = VectorX::Zero(6);
  const Pose before = chain.FootPose(x);
  x[5] = 0.3;
  const Pose after = chain.FootPose(x);
  EXPECT_NEAR(RotationLog(before.linear().transpose() * after.linear()).norm(), 0.3, 1e-12);
  EXPECT_LT((before.matrix() - chain.X_BF_zero.matrix()).norm(), 1e-12) << "positions zero";
}

TEST(LegChain, ControlsAsManyRowsAsItHasJointsPositionFirst) {
  const LegChain six(Made(SixJoints()), 0);
  EXPECT_EQ(six.num_rows, 6);
  EXPECT_EQ(six.rows, (std::array<int, 6>{0, 1, 2, 4, 3, 5})) << "pitch, roll, then heading";
  EXPECT_TRUE(six.IsPlain());
  std::vector<SyntheticJoint> five = SixJoints();
  five.pop_back();
  const LegChain line(Made(five), 0);
  EXPECT_EQ(line.num_rows, 5);
  EXPECT_EQ(line.rows[4], 5) << "a line keeps its heading, since it cannot roll";
  const LegChain point(Robot("a1"), 0);
  EXPECT_EQ(point.num_rows, 3);
}

TEST(LegChain, ItsLimitsAreThoseOfAllJointsThatACoordinateMoves) {
  const RobotModel model = AnyRobot("mimic");
  const LegChain chain(model, 0);
  EXPECT_GT(chain.links.size(), chain.dofs.size());
  EXPECT_FALSE(chain.IsPlain());
  for (Eigen::Index c = 0; c < chain.lower.size(); ++c) {
    for (const LegChain::Link& link : chain.links) {
      if (link.coordinate != c) continue;
      const Joint* joint = nullptr;
      for (const Joint& one : model.joints) joint = one.name == link.name ? &one : joint;
      ASSERT_NE(joint, nullptr);
      for (const double end : {chain.lower[c], chain.upper[c]}) {
        const double position = link.multiplier * end + link.offset;
        EXPECT_GE(position, joint->lower - 1e-12) << link.name;
        EXPECT_LE(position, joint->upper + 1e-12) << link.name;
      }
    }
  }
  EXPECT_FALSE(LegChain(AnyRobot("sliding"), 0).IsPlain()) << "a prismatic joint";
}

TEST(LegChain, LeftAndRightMirrorEachOther) {
  const RobotModel model = Made(SixJoints());
  const LegChain left(model, 0), right(model, 1);
  const Vector3 a = left.X_BF_zero.translation(), b = right.X_BF_zero.translation();
  EXPECT_NEAR(a.y() - 0.005, -(b.y() - 0.005), 1e-12) << "the knee's offset is not mirrored";
  EXPECT_NEAR(a.z(), b.z(), 1e-12);
  EXPECT_TRUE(left.shared_dofs.empty());
}

TEST(LegChain, RefusesALegThatTheRobotHasNot) {
  const RobotModel model = Robot("a1");
  EXPECT_THROW(LegChain(model, 4), InvalidArgument);
  EXPECT_THROW(LegChain(model, -1), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
