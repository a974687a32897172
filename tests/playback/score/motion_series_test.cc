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

TEST(MotionSeries, AStillSphereFootThatRollsDoesNotSlide) {
  const RobotModel model = synthetic::Robot(4, FootType::kSphere);
  const MotionPlan plan = synthetic::StandingPlan(model, 0.1);
  PlaybackLog log = synthetic::PerfectLog(model, plan);
  LogSample& sample = log.samples[10];
  sample.v.setZero();
  sample.v[4] = 1.0;      // the base pitches about its own centre
  sample.v[0] = kHeight;  // so that the points below it stand still
  const MotionSeries series = MakeMotionSeries(model, plan, log, {});
  EXPECT_NEAR(series.measured[10].feet[0].slide_m_s, 0.0, 1e-9);
  EXPECT_NEAR(series.measured[10].feet[0].height_m, 0.0, 1e-12);
}

TEST(MotionSeries, EnergyMarginOfAPointMassOverARectangle) {
  MotionSample sample;
  sample.p_WC = {0.02, 0.0, 0.4};
  sample.support.points_W = {{-0.1, -0.2, 0.0}, {0.1, -0.2, 0.0}, {0.1, 0.2, 0.0}, {-0.1, 0.2, 0.0}};
  sample.support.polygon = {{-0.1, -0.2}, {0.1, -0.2}, {0.1, 0.2}, {-0.1, 0.2}};
  EXPECT_NEAR(EnergyMargin(sample), std::hypot(0.08, 0.4) - 0.4, 1e-12);
  sample.p_WC.x() = 0.15;
  EXPECT_NEAR(EnergyMargin(sample), -(std::hypot(0.05, 0.4) - 0.4), 1e-12) << "already beyond the front edge";
  sample.support.polygon = {{0.0, -0.2}, {0.0, 0.2}};
  sample.support.reference_W = Vector3::Zero();
  EXPECT_NEAR(EnergyMargin(sample), -(std::hypot(0.15, 0.4) - 0.4), 1e-12) << "a line";
}

TEST(MotionSeries, AnInclinedEdgeIsTippedOverMoreEasily) {
  MotionSample sample;
  sample.p_WC = {0.0, 0.0, 0.4};
  const double rise = 0.1;
  sample.support.points_W = {{-0.2, -0.1, -rise}, {0.2, -0.1, rise}, {0.2, 0.1, rise}, {-0.2, 0.1, -rise}};
  sample.support.polygon = {{-0.2, -0.1}, {0.2, -0.1}, {0.2, 0.1}, {-0.2, 0.1}};
  // Messuri and Klein: R (1 - cos theta) cos psi, with psi the inclination of the long edges.
  const double cos_psi = 0.2 / std::hypot(0.2, rise), high = 0.4 * cos_psi;
  const double R = std::hypot(high, 0.1);
  EXPECT_NEAR(EnergyMargin(sample), (R - high) * cos_psi, 1e-12);
}

}  // namespace
}  // namespace gaitwright
