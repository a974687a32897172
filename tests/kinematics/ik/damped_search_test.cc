// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/ik/damped_search.h"

#include "tests/kinematics/made_robots.h"

namespace gaitwright {
namespace {

class DampedSearchTest : public testing::TestWithParam<const char*> {
 protected:
  DampedSearchTest() : model_(AnyRobot(GetParam())), chain_(model_, 0) {
    lower_ = chain_.lower.cwiseMax(-2.0);
    upper_ = chain_.upper.cwiseMin(2.0);
  }
  /// Coordinates well within the limits.
  VectorX Inner() {
    const VectorX shares = (0.4 * random_.Vector(chain_.num_coordinates())).array().tanh();
    return 0.5 * (lower_ + upper_) + 0.45 * shares.cwiseProduct(upper_ - lower_);
  }

  RobotModel model_;
  LegChain chain_;
  VectorX lower_, upper_;
  RandomState random_{23};
};

TEST_P(DampedSearchTest, FromNearbyItFindsThePoseAgain) {
  int found = 0;
  constexpr int kTrials = 30;
  for (int i = 0; i < kTrials; ++i) {
    const VectorX x = Inner();
    const Pose X_BF = chain_.FootPose(x);
    const DampedSearch search =
        DescendToPose(chain_, X_BF, lower_, upper_, x + 0.02 * random_.Vector(chain_.num_coordinates()));
    EXPECT_TRUE((search.coordinates.array() >= lower_.array()).all());
    EXPECT_TRUE((search.coordinates.array() <= upper_.array()).all());
    if (!search.converged) continue;
    ++found;
    const Pose X = chain_.FootPose(search.coordinates);
    EXPECT_LT((X.translation() - X_BF.translation()).norm(), 1e-10);
    EXPECT_LT(search.distance_m, 1e-10);
    EXPECT_LT(search.angle_rad, 1e-9);
    if (chain_.num_rows == 6) {
      EXPECT_LT((X.linear() - X_BF.linear()).norm(), 1e-9);
    }
  }
  EXPECT_GE(found, kTrials - 3);
}

TEST_P(DampedSearchTest, AtTheTargetItStaysWhereItIs) {
  const VectorX x = Inner();
  const DampedSearch search = DescendToPose(chain_, chain_.FootPose(x), lower_, upper_, x);
  EXPECT_TRUE(search.converged);
  EXPECT_EQ(search.iterations, 0);
  EXPECT_EQ(search.coordinates, x);
}

TEST_P(DampedSearchTest, ATargetOutOfReachLeavesWhatItSays) {
  Pose far = chain_.FootPose(chain_.standing);
  far.translation() -= 3.0 * chain_.length_m * Vector3::UnitZ();
  const DampedSearch search = SearchPose(chain_, far, lower_, upper_, chain_.standing, 3);
  EXPECT_FALSE(search.converged);
  const double left = (chain_.FootPose(search.coordinates).translation() - far.translation()).norm();
  EXPECT_NEAR(search.distance_m, left, 1e-9);
  EXPECT_GT(left, 1.5 * chain_.length_m);
}

INSTANTIATE_TEST_SUITE_P(AnyRobots, DampedSearchTest, testing::ValuesIn(kAnyRobots),
                         [](const auto& given) { return std::string(given.param); });

TEST(DampedSearch, AStartOutsideOfTheLimitsIsMovedIn) {
  const LegChain chain(Made(SixJoints()), 0);
  const VectorX lower = VectorX::Constant(6, -0.5), upper = VectorX::Constant(6, 0.5);
  const VectorX inside = VectorX::Constant(6, 0.2);
  const DampedSearch search = DescendToPose(chain, chain.FootPose(inside), lower, upper, VectorX::Constant(6, 3.0));
  EXPECT_LE(search.coordinates.cwiseAbs().maxCoeff(), 0.5);
}

TEST(DampedSearch, AJointAtItsLimitLetsTheOthersGoOn) {
  const LegChain chain(Made(SixJoints()), 0);
  VectorX target(6);
  target << 0.1, -0.2, 0.3, 0.8, -0.4, 0.1;
  VectorX lower = VectorX::Constant(6, -1.5), upper = VectorX::Constant(6, 1.5);
  upper[3] = 0.8;  // the knee is at its limit in the pose
  VectorX start = target + VectorX::Constant(6, -0.1);
  const DampedSearch search = DescendToPose(chain, chain.FootPose(target), lower, upper, start);
  EXPECT_TRUE(search.converged);
  EXPECT_LT((search.coordinates - target).norm(), 1e-6);
}

TEST(DampedSearch, OtherStartsFindWhatTheGuessDoesNot) {
  const LegChain chain(Made(SixJoints()), 0);
  VectorX target(6), guess(6);
  target << 0.5, 0.3, -0.7, 1.2, -0.5, -0.2;
  guess << -1.0, -1.0, 1.0, -1.9, 1.1, 1.0;  // the knee bent in the other direction
  const VectorX lower = chain.lower, upper = chain.upper;
  const Pose X_BF = chain.FootPose(target);
  const DampedSearch many = SearchPose(chain, X_BF, lower, upper, guess, 50);
  EXPECT_TRUE(many.converged);
  EXPECT_LT((chain.FootPose(many.coordinates).matrix() - X_BF.matrix()).norm(), 1e-8);
  const DampedSearch again = SearchPose(chain, X_BF, lower, upper, guess, 50);
  EXPECT_EQ(many.coordinates, again.coordinates) << "the random starts are the same each time";
  EXPECT_EQ(many.iterations, again.iterations);
}

}  // namespace
}  // namespace gaitwright
