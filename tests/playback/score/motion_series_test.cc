// SPDX-License-Identifier: BSD-3-Clause
#include "playback/score/motion_series.h"

#include <gtest/gtest.h>

#include "tests/playback/synthetic.h"

namespace gaitwright {
namespace {

using synthetic::kHeight;

TEST(MotionSeries, PlannedAndMeasuredZmpAreTheReference) {
  const RobotModel model = synthetic::Robot(2, FootType::kSole);
  const MotionPlan plan = synthetic::StandingPlan(model, 0.5, {0.02, -0.01});
  const MotionSeries series = MakeMotionSeries(model, plan, synthetic::PerfectLog(model, plan), {});
  ASSERT_EQ(series.planned.size(), 101u);
  for (std::size_t k = 0; k < series.planned.size(); ++k) {
    ASSERT_TRUE(series.measured[k].has_zmp);
    EXPECT_LT((series.planned[k].p_WZ - Vector2(0.02, -0.01)).norm(), 1e-9);
    EXPECT_LT((series.measured[k].p_WZ - Vector2(0.02, -0.01)).norm(), 1e-9);
    EXPECT_NEAR(series.measured[k].omega_rad_s, std::sqrt(kGravity / kHeight), 1e-9);
  }
}

TEST(MotionSeries, UnfilteredZmpOfAWalkIsItsPendulumReference) {
  const RobotModel model = synthetic::Robot(2, FootType::kSole);
  const MotionPlan plan = synthetic::SteppingPlan(model);
  ScoreOptions options;
  options.zmp_filter_s = 0.0;
  const MotionSeries series = MakeMotionSeries(model, plan, synthetic::PerfectLog(model, plan), options);
  double apart = 0.0, largest_margin = -1.0;
  for (std::size_t k = 0; k < series.planned.size(); ++k) {
    apart = std::max(apart, (series.planned[k].p_WZ - series.measured[k].p_WZ).norm());
    largest_margin = std::max(largest_margin, series.planned[k].zmp_margin_m());
    EXPECT_GT(series.planned[k].zmp_margin_m(), 0.03);
  }
  EXPECT_LT(apart, 1e-3);
  EXPECT_GT(largest_margin, 0.039) << "in the middle of a sole 40 mm from its edge, or better";
}

TEST(MotionSeries, LittleForceHasNoZmpAndTheFilterStartsAnew) {
  const RobotModel model = synthetic::Robot(2, FootType::kSole);
  const MotionPlan plan = synthetic::StandingPlan(model, 0.5);
  PlaybackLog log = synthetic::PerfectLog(model, plan);
  for (std::size_t k = 40; k < 50; ++k) {
    for (ContactWrench& wrench : log.samples[k].wrenches) wrench.force_W *= 0.04;
  }
  for (std::size_t k = 50; k < log.samples.size(); ++k) {
    for (ContactWrench& wrench : log.samples[k].wrenches) wrench.moment_W.y() += -0.03 * wrench.force_W.z();
  }
  const MotionSeries series = MakeMotionSeries(model, plan, log, {});
  EXPECT_TRUE(series.measured[39].has_zmp);
  EXPECT_FALSE(series.measured[40].has_zmp);
  EXPECT_FALSE(series.measured[49].has_zmp);
  EXPECT_NEAR(series.measured[50].p_WZ.x(), 0.03, 1e-9) << "no memory across the gap";
}

TEST(MotionSeries, TheFilterStartsAnewWhereTheSupportChanges) {
  // Otherwise the ZMP, which moves from foot to foot within milliseconds, would be compared with the next support.
  const RobotModel model = synthetic::Robot(2, FootType::kSole);
  const MotionPlan plan = synthetic::SteppingPlan(model);
  ScoreOptions slow, none;
  slow.zmp_filter_s = 0.05;
  none.zmp_filter_s = 0.0;
  const PlaybackLog log = synthetic::PerfectLog(model, plan);
  const MotionSeries filtered = MakeMotionSeries(model, plan, log, slow),
                     raw = MakeMotionSeries(model, plan, log, none);
  int changes = 0;
  for (std::size_t k = 1; k < raw.planned.size(); ++k) {
    if (raw.planned[k].stance == raw.planned[k - 1].stance) continue;
    ++changes;
    EXPECT_EQ(filtered.planned[k].p_WZ, raw.planned[k].p_WZ);
    EXPECT_EQ(filtered.measured[k].p_WZ, raw.measured[k].p_WZ);
  }
  EXPECT_GE(changes, 2);
}

TEST(MotionSeries, AStillSphereFootThatRollsDoesNotSlide) {
  const RobotModel model = synthetic::Robot(4, FootType::kSphere);
  const MotionPlan plan = synthetic::StandingPlan(model, 0.1);
  PlaybackLog log = synthetic::PerfectLog(model, plan);
  LogSample& sample = log.samples[10];
  sample.v.setZero();
  sample.v[4] = 1.0;      // the base pitches about its own centre
  sample.v[0] = kHeight;  // so that points at the ground stand still
  const MotionSeries series = MakeMotionSeries(model, plan, log, {});
  EXPECT_NEAR(series.measured[10].feet[0].slide_m_s, 0.0, 1e-9);
  EXPECT_NEAR(series.measured[10].feet[0].height_m, 0.0, 1e-12);
}

}  // namespace
}  // namespace gaitwright
