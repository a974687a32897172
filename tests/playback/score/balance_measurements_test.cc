// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "playback/score/measurements.h"
#include "tests/playback/played.h"

namespace gaitwright {
namespace {

using synthetic::kHalfLength;
using synthetic::kStep;
using synthetic::Played;
using synthetic::Stood;
using synthetic::Walked;

/// Without the low-pass filter of the ZMP.
StabilityReport RawScore(const Played& c) {
  ScoreOptions options;
  options.zmp_filter_s = 0.0;
  return Score(c.model, c.plan, c.log, options);
}

void ShiftZmpForward(LogSample& sample, double by_m) {
  for (ContactWrench& wrench : sample.wrenches) wrench.moment_W.y() -= by_m * wrench.force_W.z();
}

/// Moves the base forward; the feet stay in place.
void ShiftBase(LogSample& sample, double by_m) {
  sample.q[0] += by_m;
  for (const int slider : {0, 3}) sample.q[7 + slider] -= by_m;
}

TEST(BalanceMeasurements, ErrorsOfTheZmpHaveMeanRootMeanSquareAndLargest) {
  Played c = Stood();
  const std::size_t count = c.log.samples.size(), even = (count + 1) / 2;
  for (std::size_t k = 0; k < count; k += 2) ShiftZmpForward(c.log.samples[k], 0.02);
  ShiftZmpForward(c.log.samples[11], -0.03);
  const double shifted = static_cast<double>(even), all = static_cast<double>(count);
  const StabilityReport report = RawScore(c);
  EXPECT_NEAR(*report.At("zmp_error_mean_m").value, (0.02 * shifted + 0.03) / all, 1e-9);
  EXPECT_NEAR(*report.At("zmp_error_rms_m").value, std::sqrt((4e-4 * shifted + 9e-4) / all), 1e-9);
  EXPECT_NEAR(*report.At("zmp_error_max_m").value, 0.03, 1e-9);
  EXPECT_NEAR(*report.At("zmp_error_max_m").at_s, 11.0 * kStep, 1e-12);
}

TEST(BalanceMeasurements, TheSmallestMarginIsAtTheSampleOfTheLargestShift) {
  Played c = Stood();
  for (std::size_t k = 0; k < 30; ++k) ShiftZmpForward(c.log.samples[k], 0.001 * static_cast<double>(k));
  const StabilityReport report = RawScore(c);
  const Metric& margin = report.At("zmp_margin_min_m");
  EXPECT_NEAR(*margin.value, kHalfLength - 0.029, 1e-9);
  EXPECT_NEAR(*margin.planned, kHalfLength, 1e-9);
  EXPECT_NEAR(*margin.at_s, 29.0 * kStep, 1e-12);
  EXPECT_EQ(*report.At("zmp_outside_fraction").value, 0.0);
}

TEST(BalanceMeasurements, WithoutForceOnTheGroundThereIsNoZmp) {
  Played c = Stood();
  for (LogSample& sample : c.log.samples) {
    for (ContactWrench& wrench : sample.wrenches) wrench = ContactWrench();
  }
  const StabilityReport report = RawScore(c);
  for (const char* key : {"zmp_margin_min_m", "zmp_margin_p05_m", "zmp_outside_fraction", "zmp_error_mean_m",
                          "zmp_error_rms_m", "zmp_error_max_m"}) {
    EXPECT_FALSE(report.At(key).value.has_value()) << key;
    EXPECT_FALSE(report.At(key).not_applied.empty()) << key;
  }
  EXPECT_TRUE(report.At("static_margin_min_m").value.has_value()) << "the feet are where they should be";
}

TEST(BalanceMeasurements, TheStaticMarginIsThatOfTheCentreOfMass) {
  Played c = Stood();
  ShiftBase(c.log.samples[60], 0.03);
  const Metric margin = RawScore(c).At("static_margin_min_m");
  EXPECT_NEAR(*margin.value, kHalfLength - 0.03, 1e-9);
  EXPECT_NEAR(*margin.planned, kHalfLength, 1e-9);
  EXPECT_NEAR(*margin.at_s, 60.0 * kStep, 1e-12);
  ShiftBase(c.log.samples[70], -0.1);
  EXPECT_NEAR(*RawScore(c).At("static_margin_min_m").value, kHalfLength - 0.1, 1e-9);
}

TEST(BalanceMeasurements, AnErrorIsReportedWithTheTimeOfItsMaximum) {
  Played c = Stood();
  for (LogSample& sample : c.log.samples) sample.q[0] += 0.01;
  c.log.samples[50].q[0] += 0.02;
  const double all = static_cast<double>(c.log.samples.size());
  for (const char* key : {"tracking_base_rms_m", "tracking_com_rms_m"}) {
    const Metric error = RawScore(c).At(key);
    EXPECT_NEAR(*error.value, std::sqrt((1e-4 * (all - 1.0) + 9e-4) / all), 1e-9) << key;
    EXPECT_NEAR(*error.at_s, 50.0 * kStep, 1e-12) << key;
  }
}

TEST(BalanceMeasurements, AMotionThatIsAsPlannedHasTheMarginsOfThePlan) {
  const Played c = Walked();
  const StabilityReport report = RawScore(c);
  for (const char* key : {"dcm_capture_margin_min_m", "static_margin_min_m", "energy_margin_min_m"}) {
    ASSERT_TRUE(report.At(key).value.has_value()) << key;
    EXPECT_NEAR(*report.At(key).value, *report.At(key).planned, 1e-9) << key;
  }
  EXPECT_NEAR(*report.At("dcm_error_max_m").value, 0.0, 1e-9);
  EXPECT_FALSE(RawScore(Stood()).At("dcm_capture_margin_min_m").value.has_value()) << "nobody steps";
}

TEST(BalanceMeasurements, TheShareWithoutAreaIsThatOfPlannedSupportOnLines) {
  const auto share = [](const Played& c) {
    return ShareWithoutArea(MakePlannedSeries(c.model, c.plan, 1.0 / kStep, ScoreOptions()));
  };
  EXPECT_EQ(share(Walked(2)), 0.0) << "soles have an area";
  EXPECT_EQ(share(Stood()), 0.0);
  // Six swings of 0.4 s on two feet, of 0.8 + 6 (0.1 + 0.4) + 0.1 + 0.8 s.
  EXPECT_NEAR(share(Walked(4)), 2.4 / 4.7, 0.01);
  EXPECT_EQ(ShareWithoutArea(MotionSeries()), 0.0);
}

}  // namespace
}  // namespace gaitwright
