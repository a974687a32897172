// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/ik/three_joint_form.h"

#include "tests/kinematics/made_robots.h"

namespace gaitwright {
namespace {

/// Abduction, hip with a lateral offset, knee; the foot is a ball 0.2 m below.
std::vector<SyntheticJoint> ThreeJoints() {
  return {{"0 0 0", "1 0 0"}, {"0 0.08 0", "0 1 0"}, {"0 0 -0.2", "0 1 0", "lower='-2.7' upper='2.7'"}};
}

class ThreeJointFormTest : public testing::Test {
 protected:
  ThreeJointFormTest() : chain_(Made(ThreeJoints(), kBallFoot), 0), form_(FitThreeJointForm(chain_)) {}
  LegBranches At(const Vector3& p_BF) const {
    Pose X = Pose::Identity();
    X.translation() = p_BF;
    return form_->Branches(X, Vector6::Zero());
  }
  ReachGap GapAt(const Vector3& p_BF) const {
    Pose X = Pose::Identity();
    X.translation() = p_BF;
    return form_->Gap(X);
  }
  LegChain chain_;
  std::shared_ptr<const LegClosedForm> form_;
};

TEST_F(ThreeJointFormTest, EachBranchReachesThePointAndOneIsTheGivenOne) {
  ASSERT_NE(form_, nullptr);
  RandomState random(41);
  for (int i = 0; i < 200; ++i) {
    const VectorX x = 1.3 * random.Vector(3).array().tanh();
    const Vector3 p_BF = chain_.FootPose(x).translation();
    const LegBranches branches = At(p_BF);
    ASSERT_GE(branches.count, 1U);
    double nearest = 1e9;
    for (std::size_t k = 0; k < branches.count; ++k) {
      const VectorX found = branches.positions[k].head<3>();
      EXPECT_LT((chain_.FootPose(found).translation() - p_BF).norm(), 1e-9);
      double gap = 0.0;
      for (int j = 0; j < 3; ++j) gap = std::max(gap, std::abs(WrapAngle(found[j] - x[j])));
      nearest = std::min(nearest, gap);
    }
    EXPECT_LT(nearest, 1e-5);
    EXPECT_EQ(GapAt(p_BF).kind, ReachGap::Kind::kNone);
  }
}

TEST_F(ThreeJointFormTest, BelowTheHipTheKneeBendsInBothDirections) {
  // Hip at (0, 0.1 + 0.08, 0) with both links 0.2 m long and 0.3 m between hip and foot.
  const LegBranches branches = At({0.0, 0.18, -0.3});
  ASSERT_EQ(branches.count, 4U) << "two knees, leg above or below the abduction axis";
  int plain = 0;
  for (std::size_t k = 0; k < branches.count; ++k) {
    const double knee = WrapAngle(branches.positions[k][2]);
    EXPECT_NEAR(std::abs(knee), 2.0 * std::acos(0.15 / 0.2), 1e-9);
    if (std::abs(WrapAngle(branches.positions[k][0])) > 1e-9) continue;
    EXPECT_NEAR(WrapAngle(branches.positions[k][1] + 0.5 * knee), 0.0, 1e-9) << "an isosceles triangle";
    ++plain;
  }
  EXPECT_EQ(plain, 2);
}

TEST_F(ThreeJointFormTest, AGapIsTheDistanceToTheNearestPoint) {
  const ReachGap far = GapAt({0.0, 0.18, -0.45});
  EXPECT_EQ(far.kind, ReachGap::Kind::kTooFar);
  EXPECT_NEAR(far.distance_m, 0.05, 2e-3);
  EXPECT_LE(far.distance_m, 0.05 + 1e-9) << "the straight leg below is one of the points within reach";
  const ReachGap near_axis = GapAt({0.1, 0.1, -0.03});
  EXPECT_EQ(near_axis.kind, ReachGap::Kind::kTooNearAxis);
  EXPECT_NEAR(near_axis.distance_m, 0.05, 1e-6) << "the foot's plane is 0.08 m from the axis";
  EXPECT_EQ(At({0.1, 0.1, -0.03}).count, 0U);
}

TEST_F(ThreeJointFormTest, TheStraightLegIsStraight) {
  VectorX x = VectorX::Zero(3);
  x[form_->knee()] = form_->straight_rad();
  const double longest = (chain_.FootPose(x).translation() - Vector3(0.0, 0.18, 0.0)).norm();
  EXPECT_NEAR(longest, 0.4, 1e-12);
}

TEST(ThreeJointForm, FitsOnlyItsFamily) {
  EXPECT_NE(FitThreeJointForm(LegChain(Robot("a1"), 0)), nullptr);
  EXPECT_EQ(FitThreeJointForm(LegChain(Robot("nao"), 0)), nullptr);
  std::vector<SyntheticJoint> aslant = ThreeJoints();
  aslant[2].axis = "0 1 0.1";
  EXPECT_EQ(FitThreeJointForm(LegChain(Made(aslant, kBallFoot), 0)), nullptr);
  std::vector<SyntheticJoint> all_pitch = ThreeJoints();
  all_pitch[0].axis = "0 1 0";
  EXPECT_EQ(FitThreeJointForm(LegChain(Made(all_pitch, kBallFoot), 0)), nullptr);
}

}  // namespace
}  // namespace gaitwright
