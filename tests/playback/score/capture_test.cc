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

TEST(Capture, TouchdownsKnowTheFeetThatStay) {
  const RobotModel model = synthetic::Robot(4, FootType::kPoint);
  const MotionPlan plan = synthetic::SteppingPlan(model);
  const auto touchdowns = TouchdownsOf(plan.schedule);
  ASSERT_EQ(touchdowns.size(), 6u);
  EXPECT_EQ(touchdowns[0].stance, FootSet{0b1001}) << "the pair that has landed stays when the other one lifts";
  EXPECT_EQ(touchdowns[1].stance, FootSet{0b0110});
  EXPECT_EQ(touchdowns[5].stance, FootSet{0b1111});
  EXPECT_NEAR(TimeToNextTouchdown(plan, touchdowns[0].time_s), 0.5, 1e-9);
  EXPECT_NEAR(TimeToNextTouchdown(plan, touchdowns[0].time_s + 0.2), 0.3, 1e-9);
  EXPECT_NEAR(TimeToNextTouchdown(plan, touchdowns[5].time_s), 0.5, 1e-9) << "the mean of those that were";
}

TEST(Capture, AHopLandsOnTheFeetThatComeDown) {
  ContactSchedule hops;
  hops.phases = {{0.0, 0.3, 3}, {0.3, 0.5, 0}, {0.5, 0.7, 1}, {0.7, 0.8, 0}, {0.8, 1.0, 2}};
  const auto touchdowns = TouchdownsOf(hops);
  ASSERT_EQ(touchdowns.size(), 2u);
  EXPECT_EQ(touchdowns[0].stance, FootSet{1});
  EXPECT_EQ(touchdowns[1].stance, FootSet{2});
}

TEST(Capture, TheSetIsTheSupportInflatedByWhatAStepReaches) {
  MotionSample sample;
  sample.omega_rad_s = 5.0;
  Support square;
  square.polygon = {{-0.1, -0.1}, {0.1, -0.1}, {0.1, 0.1}, {-0.1, 0.1}};
  sample.dcm_W = {0.15, 0.0};
  const double inflation = 0.3 * std::exp(-5.0 * 0.4);
  EXPECT_NEAR(CaptureMargin(square, sample, 0.3, 0.4), inflation - 0.05, 1e-12);
  EXPECT_NEAR(CaptureMargin(square, sample, 0.0, 0.4), -0.05, 1e-12);
  // The pendulum itself: from the border, with the ZMP on the edge, the DCM is a full step away when the foot lands.
  const double border = 0.1 + inflation;
  EXPECT_NEAR((border - 0.1) * std::exp(5.0 * 0.4), 0.3, 1e-12);
}

}  // namespace
}  // namespace gaitwright
