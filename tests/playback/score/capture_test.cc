// SPDX-License-Identifier: BSD-3-Clause
#include "playback/score/capture.h"

#include <gtest/gtest.h>

#include "tests/playback/synthetic.h"

namespace gaitwright {
namespace {

TEST(Capture, ReachIsTwoStretchedLegsFromTheStandingHips) {
  const RobotModel model = synthetic::Robot(2, FootType::kSole);
  // Legs of 0.6 m; the highest joint of a leg stands 0.5 m over the foot.
  EXPECT_NEAR(StepReach(model, 0.95), 2.0 * std::sqrt(0.57 * 0.57 - 0.25), 1e-9);
  EXPECT_NEAR(StepReach(model, 0.5), 0.2 * 0.6, 1e-9) << "the least";
}

TEST(Capture, StagesGoToTheNextTouchdown) {
  const RobotModel model = synthetic::Robot(4, FootType::kPoint);
  const MotionPlan plan = synthetic::SteppingPlan(model);
  const auto times = TouchdownTimes(plan.schedule);
  ASSERT_EQ(times.size(), 6u);
  const auto stages = StagesToNextTouchdown(plan, times[0]);
  ASSERT_EQ(stages.size(), 2u);
  EXPECT_EQ(stages[0].stance, FootSet{0b1111});
  EXPECT_NEAR(stages[0].duration_s, 0.1, 1e-9);
  EXPECT_EQ(stages[1].stance, FootSet{0b1001}) << "the pair that has landed stays when the other one lifts";
  EXPECT_NEAR(stages[1].duration_s, 0.4, 1e-9);
  const auto within = StagesToNextTouchdown(plan, times[0] + 0.2);
  ASSERT_EQ(within.size(), 1u);
  EXPECT_NEAR(within[0].duration_s, 0.3, 1e-9);
  const auto last = StagesToNextTouchdown(plan, times[5]);
  ASSERT_EQ(last.size(), 1u);
  EXPECT_EQ(last[0].stance, FootSet{0b1111});
  EXPECT_NEAR(last[0].duration_s, 0.5, 1e-9) << "the mean of those that were";
}

struct Standing {
  RobotModel model = synthetic::Robot(2, FootType::kSole);
  DynamicsScratch scratch{model};
  MotionSample sample;

  Standing() {
    ForwardKinematics(model, synthetic::StandingPlan(model, 0.1).whole_body.q[0], scratch);
    sample.omega_rad_s = 5.0;
  }
  double Margin(const std::vector<CaptureStage>& stages, double reach) {
    return CaptureMargin(model, scratch, FlatTerrain(), stages, sample, reach).value();
  }
};

TEST(Capture, WithOneStageTheSetIsTheSupportInflatedByWhatAStepReaches) {
  Standing standing;
  standing.sample.dcm_W = {synthetic::kHalfLength + 0.05, 0.1};
  const double inflation = 0.3 * std::exp(-5.0 * 0.4);
  EXPECT_NEAR(standing.Margin({{0.4, 1}}, 0.3), inflation - 0.05, 1e-12);
  EXPECT_NEAR(standing.Margin({{0.4, 1}}, 0.0), -0.05, 1e-12);
  EXPECT_NEAR(standing.Margin({{0.1, 0}, {0.4, 1}}, 0.3), inflation - 0.05, 1e-12) << "flight first";
  EXPECT_FALSE(CaptureMargin(standing.model, standing.scratch, FlatTerrain(), {{0.4, 0}}, standing.sample, 0.3));
}

TEST(Capture, FromTheBorderOfTheSetThePendulumJustReachesTheStep) {
  // Both soles for 0.15 s, then the left one for 0.35 s. In each support, the ZMP stays at the rightmost point that a
  // DCM on the right border can use.
  Standing standing;
  const double w = 5.0, first = 0.15, second = 0.35, reach = 0.2;
  const double right_of_both = -0.14, right_of_left = 0.06;
  standing.sample.dcm_W = {0.0, 0.0};
  const double border = -standing.Margin({{first, 3}, {second, 1}}, reach);
  ASSERT_GT(standing.Margin({{first, 3}, {second, 1}}, reach), 0.0) << "the middle is inside: the first stage helps";
  ASSERT_LT(standing.Margin({{second, 1}}, reach), 0.0) << "and without it it is not";
  double xi = border;  // the distance from the middle to the right border, which is the nearest one
  xi = right_of_both + (xi - right_of_both) * std::exp(w * first);
  xi = right_of_left + (xi - right_of_left) * std::exp(w * second);
  EXPECT_NEAR(xi, right_of_left - reach, 1e-9);
}

}  // namespace
}  // namespace gaitwright
