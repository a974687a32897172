// SPDX-License-Identifier: BSD-3-Clause
// Motions of a scene: columns by sample, outlines of footholds, curves of swings.
#include <gtest/gtest.h>

#include <cmath>

#include "playback/viewer/scene_parts_internal.h"
#include "tests/playback/played.h"
#include "tests/playback/viewer/unpacked.h"

namespace gaitwright {
namespace {

using unpacked::Floats;

TEST(SceneMotion, AFootholdOfASoleHasItsCornersAtItsPose) {
  const synthetic::Played c = synthetic::Walked(2, {.count = 2});
  MotionPlan plan = c.plan;
  Foothold foothold;
  foothold.X_WF.translation() = Vector3(1.0, 2.0, 0.3);
  foothold.X_WF.linear() = Eigen::AngleAxisd(0.5 * M_PI, Vector3::UnitZ()).toRotationMatrix();
  foothold.touchdown_s = 0.25;
  foothold.liftoff_s = 0.75;
  plan.footsteps.footholds = {foothold};
  const auto scene = FootholdsScene(c.model, plan);
  ASSERT_EQ(scene.size(), 1U);
  EXPECT_EQ(scene[0]["touchdown_s"], 0.25);
  EXPECT_EQ(scene[0]["liftoff_s"], 0.75);
  ASSERT_EQ(scene[0]["outline_m"].size(), 4U);
  // The first corner is at (0.08, -0.04) of the sole; turned by 90 degrees to the left it is (0.04, 0.08).
  EXPECT_NEAR(scene[0]["outline_m"][0][0].get<double>(), 1.04, 1e-12);
  EXPECT_NEAR(scene[0]["outline_m"][0][1].get<double>(), 2.08, 1e-12);
  EXPECT_NEAR(scene[0]["outline_m"][0][2].get<double>(), 0.3, 1e-12);
}

// Legs are 0.6 m long: the circle's radius is 0.04 of that.
TEST(SceneMotion, AFootholdWithoutASoleIsACircle) {
  const synthetic::Played c = synthetic::Walked(4, {.count = 2});
  const auto scene = FootholdsScene(c.model, c.plan);
  ASSERT_FALSE(scene.empty());
  EXPECT_EQ(scene.size(), c.plan.footsteps.footholds.size());
  const Vector3 centre = c.plan.footsteps.footholds[0].X_WF.translation();
  Vector3 mean = Vector3::Zero();
  for (const auto& corner : scene[0]["outline_m"]) {
    const Vector3 p(corner[0].get<double>(), corner[1].get<double>(), corner[2].get<double>());
    EXPECT_NEAR((p - centre).norm(), 0.024, 1e-12);
    mean += p / static_cast<double>(scene[0]["outline_m"].size());
  }
  EXPECT_LT((mean - centre).norm(), 1e-12);
}

TEST(SceneMotion, ASwingsCurveIsLiftedInItsMiddle) {
  MotionPlan plan;
  SwingTrajectory swing;
  swing.foot = 1;
  swing.start_s = 1.0;
  swing.end_s = 1.5;
  swing.X_WF_end.translation() = Vector3(0.4, 0.0, 0.0);
  swing.lift_m = 0.06;
  plan.swings = {swing};
  const auto scene = SwingsScene(plan);
  EXPECT_EQ(scene[0]["foot"], 1);
  const auto points = Floats(scene[0]["points_m"]);
  ASSERT_EQ(points.size(), 75U) << "25 points";
  EXPECT_NEAR(points[36], 0.2, 1e-6) << "half way";
  EXPECT_NEAR(points[38], 0.06, 1e-6);
  for (std::size_t i = 0; i < 25; ++i) {
    EXPECT_NEAR(points[3 * i + 2], points[3 * (24 - i) + 2], 1e-6) << "there and back alike";
    EXPECT_LE(points[3 * i + 2], 0.06 + 1e-6);
  }
}

TEST(SceneMotion, AStrideKeepsEverySoManyethSample) {
  const synthetic::Played c = synthetic::Stood();
  const MotionSeries series = MakeMotionSeries(c.model, c.plan, c.log, {});
  const TrackScenes all = TracksScene(c.model, c.plan, &c.log, series, 1);
  const TrackScenes third = TracksScene(c.model, c.plan, &c.log, series, 3);
  const auto times = Floats(all.time_s), fewer = Floats(third.time_s);
  ASSERT_EQ(times.size(), series.planned.size());
  ASSERT_EQ(fewer.size(), (times.size() + 2) / 3);
  for (std::size_t k = 0; k < fewer.size(); ++k) EXPECT_EQ(fewer[k], times[3 * k]);
  EXPECT_TRUE(TracksScene(c.model, c.plan, nullptr, series, 1).measured.is_null());
}

TEST(SceneMotion, AZmpThatIsMissingIsAGap) {
  const synthetic::Played c = synthetic::Stood();
  MotionSeries series = MakeMotionSeries(c.model, c.plan, c.log, {});
  series.measured[5].has_zmp = false;
  const TrackScenes scene = TracksScene(c.model, c.plan, &c.log, series, 1);
  const auto zmp = Floats(scene.measured["zmp_m"]), margin = Floats(scene.measured["zmp_margin_m"]);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_TRUE(std::isnan(zmp[15 + i]));
    EXPECT_FALSE(std::isnan(zmp[12 + i]));
  }
  EXPECT_TRUE(std::isnan(margin[5]));
  EXPECT_FALSE(std::isnan(margin[6]));
}

TEST(SceneMotion, ContactIsByFootAndSupportsAreOneAfterTheOther) {
  synthetic::Played c = synthetic::Stood();
  MotionSeries series = MakeMotionSeries(c.model, c.plan, c.log, {});
  c.log.samples[0].contact = 2;
  c.log.samples[1].contact = 1;
  series.measured[0].support.polygon = {{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}};
  series.measured[1].support.polygon = {};
  series.measured[1].has_zmp = false;
  const TrackScenes scene = TracksScene(c.model, c.plan, &c.log, series, 1);
  const auto contact = unpacked::Numbers<std::uint8_t>(scene.measured["contact"], "u8");
  EXPECT_EQ(std::vector<std::uint8_t>(contact.begin(), contact.begin() + 4), (std::vector<std::uint8_t>{0, 1, 1, 0}));
  const auto first = unpacked::Numbers<std::uint32_t>(scene.measured["support_first"], "u32");
  EXPECT_EQ(first[0], 0U);
  EXPECT_EQ(first[1], 3U);
  EXPECT_EQ(first[2], 3U) << "in flight";
}

}  // namespace
}  // namespace gaitwright
