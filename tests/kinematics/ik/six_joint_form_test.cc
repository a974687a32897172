// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/ik/six_joint_form.h"

#include "tests/kinematics/made_robots.h"

namespace gaitwright {
namespace {

/// Two axes at the hip, a knee, three axes at the ankle.
std::vector<SyntheticJoint> ReversedJoints() {
  return {{"0 0 0", "1 0 0"},    {"0 0 0", "0 1 0"}, {"0.01 0.005 -0.3", "0 1 0", "lower='-2' upper='2'"},
          {"0 0 -0.3", "0 1 0"}, {"0 0 0", "1 0 0"}, {"0 0 0", "0 0 1"}};
}

/// The smallest difference of positions from one of the branches, modulo full turns.
double NearestBranch(const LegBranches& branches, const VectorX& positions) {
  double nearest = 1e9;
  for (std::size_t i = 0; i < branches.count; ++i) {
    double gap = 0.0;
    for (int j = 0; j < 6; ++j) gap = std::max(gap, std::abs(WrapAngle(branches.positions[i][j] - positions[j])));
    nearest = std::min(nearest, gap);
  }
  return nearest;
}

class SixJointFormTest : public testing::TestWithParam<bool> {
 protected:
  SixJointFormTest() : chain_(Made(GetParam() ? ReversedJoints() : SixJoints()), 0), form_(FitSixJointForm(chain_)) {}
  LegChain chain_;
  std::shared_ptr<const LegClosedForm> form_;
  RandomState random_{31};
};

TEST_P(SixJointFormTest, EachBranchReachesThePoseAndOneIsTheGivenOne) {
  ASSERT_NE(form_, nullptr);
  EXPECT_EQ(form_->knee(), GetParam() ? 2 : 3);
  EXPECT_LT(form_->misfit(), 1e-12);
  for (int i = 0; i < 200; ++i) {
    const VectorX x = 1.2 * random_.Vector(6).array().tanh();
    const Pose X_BF = chain_.FootPose(x);
    const LegBranches branches = form_->Branches(X_BF, Vector6::Zero());
    ASSERT_GE(branches.count, 1U);
    EXPECT_LE(branches.count, LegBranches::kMost);
    for (std::size_t k = 0; k < branches.count; ++k)
      EXPECT_LT((chain_.FootPose(branches.positions[k]).matrix() - X_BF.matrix()).norm(), 1e-7);
    EXPECT_LT(NearestBranch(branches, x), 1e-5);
    EXPECT_EQ(form_->Gap(X_BF).kind, ReachGap::Kind::kNone);
  }
}

TEST_P(SixJointFormTest, BeyondTheStraightLegTheGapIsWhatIsMissing) {
  ASSERT_NE(form_, nullptr);
  VectorX x = VectorX::Zero(6);
  x[form_->knee()] = form_->straight_rad();
  const Pose X_straight = chain_.FootPose(x);
  // Hip and ankle of the straight leg.
  const Vector3 hip = chain_.links[0].point_B;
  const std::size_t ankle_link = GetParam() ? 3 : 4;
  LegChain::Jacobian screws(6, 6), J(6, 6);
  chain_.FootPose(x, screws, J);
  const Vector3 ankle = screws.col(static_cast<Eigen::Index>(ankle_link)).head<3>();
  Pose far = X_straight;
  far.translation() += 0.04 * (ankle - hip).normalized();
  const ReachGap gap = form_->Gap(far);
  EXPECT_EQ(gap.kind, ReachGap::Kind::kTooFar);
  EXPECT_NEAR(gap.distance_m, 0.04, 1e-9);
  EXPECT_EQ(form_->Branches(far, Vector6::Zero()).count, 0U);
  Pose near = X_straight;
  near.translation() -= 0.04 * (ankle - hip).normalized();
  EXPECT_EQ(form_->Gap(near).kind, ReachGap::Kind::kNone);
}

TEST_P(SixJointFormTest, ATurnThatTheAnkleCannotMakeIsReported) {
  ASSERT_NE(form_, nullptr);
  for (int i = 0; i < 50; ++i) {
    Pose X_BF = chain_.FootPose(0.5 * random_.Vector(6));
    X_BF.linear() = RotationExp(random_.Vector(3)) * X_BF.linear();
    const ReachGap gap = form_->Gap(X_BF);
    const bool reached = form_->Branches(X_BF, Vector6::Zero()).count > 0;
    EXPECT_EQ(reached, gap.kind == ReachGap::Kind::kNone);
    if (gap.kind == ReachGap::Kind::kTurned) {
      EXPECT_GT(gap.angle_rad, 0.0);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(BothEnds, SixJointFormTest, testing::Bool(),
                         [](const auto& given) { return given.param ? "ThreeAtTheAnkle" : "ThreeAtTheHip"; });

TEST(SixJointForm, FitsOnlyItsFamily) {
  EXPECT_NE(FitSixJointForm(LegChain(Robot("nao"), 0)), nullptr) << "its first axis lies at 45 degrees";
  EXPECT_EQ(FitSixJointForm(LegChain(Robot("a1"), 0)), nullptr) << "three joints";
  LegChain slides(Made(SixJoints()), 0), follows = slides;
  EXPECT_NE(FitSixJointForm(slides), nullptr);
  slides.links[3].turns = false;
  follows.dofs.pop_back();  // two joints of one coordinate
  EXPECT_EQ(FitSixJointForm(slides), nullptr);
  EXPECT_EQ(FitSixJointForm(follows), nullptr);
  std::vector<SyntheticJoint> apart = SixJoints();
  apart[2].xyz = "0.02 0 0";  // the hip's third axis misses the others
  apart[5].xyz = "0 0 -0.02";
  EXPECT_EQ(FitSixJointForm(LegChain(Made(apart), 0)), nullptr);
  std::vector<SyntheticJoint> parallel = SixJoints();
  parallel[1].axis = "0 0 1";
  EXPECT_EQ(FitSixJointForm(LegChain(Made(parallel), 0)), nullptr);
}

}  // namespace
}  // namespace gaitwright
