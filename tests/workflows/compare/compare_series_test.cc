// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "kinematics/base/non_finite.h"
#include "tests/playback/played.h"
#include "workflows/compare/compare_parts_internal.h"

namespace gaitwright {
namespace {

using Values = std::vector<double>;

ComparedSeries SeriesWith(SeriesScale scale, const Values& a, const Values& b) {
  return {"a quantity", "rad", scale, a, b};
}

SharedTime SharedEvery(double step_s, std::size_t count) {
  SharedTime shared;
  for (std::size_t k = 0; k < count; ++k) shared.time_s.push_back(step_s * static_cast<double>(k));
  shared.end_s = shared.time_s.back();
  return shared;
}

SeriesDifference DifferenceOfOne(const ComparedSeries& series, double tolerance, bool noisy = false,
                                 double leg_m = 1.0) {
  return DifferencesOf({series}, SharedEvery(0.1, series.a.size()), leg_m, tolerance, noisy).at(0);
}

TEST(CompareSeries, LargestRootMeanSquareAndFirstAreOfTheDifferences) {
  const SeriesDifference d = DifferenceOfOne(SeriesWith(SeriesScale::kAngle, {0, 0, 0, 0}, {0.0, 0.3, -0.4, 0.1}), 0.2);
  EXPECT_EQ(d.samples, 4);
  EXPECT_DOUBLE_EQ(d.largest, 0.4);
  EXPECT_DOUBLE_EQ(d.at_s, 0.2);
  EXPECT_DOUBLE_EQ(d.rms, std::sqrt((0.09 + 0.16 + 0.01) / 4.0));
  EXPECT_DOUBLE_EQ(d.tolerance, 0.2) << "of one radian";
  ASSERT_TRUE(d.first_s);
  EXPECT_DOUBLE_EQ(*d.first_s, 0.1);
  EXPECT_DOUBLE_EQ(d.first_b, 0.3);
}

TEST(CompareSeries, WhatOneSideDoesNotHaveIsPassedOver) {
  const SeriesDifference some =
      DifferenceOfOne(SeriesWith(SeriesScale::kAngle, {kNaN, 1.0, 2.0}, {5.0, 1.5, kNaN}), 0.1);
  EXPECT_EQ(some.samples, 1);
  EXPECT_DOUBLE_EQ(some.rms, 0.5);
  const SeriesDifference none = DifferenceOfOne(SeriesWith(SeriesScale::kAngle, {kNaN, kNaN}, {1.0, 2.0}), 0.1);
  EXPECT_EQ(none.samples, 0);
  EXPECT_EQ(none.rms, 0.0);
  EXPECT_FALSE(none.first_s);
}

TEST(CompareSeries, TolerancesScaleWithTheKindOfQuantity) {
  const Values from = {0.0, 2.0}, to = {0.0, 2.0};  // a span of two
  const auto tolerance = [&](SeriesScale scale, double leg_m) {
    return DifferenceOfOne(SeriesWith(scale, from, to), 0.1, false, leg_m).tolerance;
  };
  EXPECT_DOUBLE_EQ(tolerance(SeriesScale::kPosition, 0.5), 0.2);
  EXPECT_DOUBLE_EQ(tolerance(SeriesScale::kSpeed, 0.5), 0.4);
  EXPECT_DOUBLE_EQ(tolerance(SeriesScale::kTorque, 0.5), 0.8);
  EXPECT_DOUBLE_EQ(tolerance(SeriesScale::kLength, 0.5), 0.05) << "of the leg";
  EXPECT_DOUBLE_EQ(tolerance(SeriesScale::kAngle, 0.5), 0.1);
  EXPECT_DOUBLE_EQ(tolerance(SeriesScale::kLength, 0.0), 0.1) << "of a metre where the leg is unknown";
}

/// A joint at rest has a tenth of the scale of the joint that moves most; joints with another unit do not count.
TEST(CompareSeries, AJointThatStaysStillHasAScale) {
  ComparedSeries moves = SeriesWith(SeriesScale::kPosition, {0.0, 3.0}, {0.0, 3.0});
  ComparedSeries rests = SeriesWith(SeriesScale::kPosition, {0.0, 0.0}, {0.0, 0.0});
  const SharedTime shared = SharedEvery(0.1, 2);
  EXPECT_DOUBLE_EQ(DifferencesOf({moves, rests}, shared, 1.0, 0.1, false)[1].tolerance, 0.1 * 0.3);
  rests.unit = "m";
  EXPECT_LT(DifferencesOf({moves, rests}, shared, 1.0, 0.1, false)[1].tolerance, 1e-8);
}

TEST(CompareSeries, WithoutToleranceOnlyRoundingIsNoDifference) {
  EXPECT_FALSE(DifferenceOfOne(SeriesWith(SeriesScale::kAngle, {0.0, 0.0}, {0.0, 1e-10}), 0.0).first_s);
  EXPECT_TRUE(DifferenceOfOne(SeriesWith(SeriesScale::kAngle, {0.0, 0.0}, {0.0, 1e-8}), 0.0).first_s);
}

TEST(CompareSeries, NoiseOfAMeasurementWidensTheTolerance) {
  Values a(200, 0.0), b;
  for (int k = 0; k < 200; ++k) b.push_back(0.01 * std::sin(37.0 * k * k));  // a fixed sequence without a pattern
  const ComparedSeries series = SeriesWith(SeriesScale::kAngle, a, b);
  const SeriesDifference noisy = DifferenceOfOne(series, 0.001, true), quiet = DifferenceOfOne(series, 0.001, false);
  EXPECT_GT(noisy.noise, 0.004);
  EXPECT_LT(noisy.noise, 0.012);
  EXPECT_NEAR(noisy.tolerance, 0.001 + kNoiseWidth * noisy.noise, 1e-12);
  EXPECT_FALSE(noisy.first_s);
  EXPECT_EQ(quiet.noise, 0.0);
  EXPECT_TRUE(quiet.first_s);
  EXPECT_EQ(DifferenceOfOne(series, 0.0, true).noise, 0.0) << "who wants none gets none";
}

/// The noise of encoder steps is at least that of a uniform distribution over a step.
TEST(CompareSeries, EncoderStepsAreNoiseThoughAJointStandsStill) {
  ComparedSeries series = SeriesWith(SeriesScale::kPosition, Values(20, 0.0), Values(20, 0.0));
  series.resolution = 0.06;
  EXPECT_NEAR(DifferenceOfOne(series, 0.1, true).noise, 0.06 / std::sqrt(12.0), 1e-12);
}

/// A computed speed belongs to two rows: it is compared at the later one, and not across a gap.
TEST(CompareSeries, AComputedSpeedShowsAtTheRowAfterIt) {
  ComparedSeries speed = SeriesWith(SeriesScale::kSpeed, {0, 0, 0, 0}, {0, 1, 0, 0});
  speed.noise_gain = {1, 1, 1, 1};
  SharedTime shared = SharedEvery(0.1, 4);
  const SeriesDifference d = DifferencesOf({speed}, shared, 1.0, 0.1, false)[0];
  EXPECT_TRUE(d.derived);
  EXPECT_DOUBLE_EQ(d.first_s.value(), 0.2);
  EXPECT_DOUBLE_EQ(d.at_s, 0.1);
  shared.gaps = {{0.1, 0.2}};
  EXPECT_DOUBLE_EQ(DifferencesOf({speed}, shared, 1.0, 0.1, false)[0].first_s.value(), 0.1);
}

TEST(CompareSeries, OfTwoMotionsHaveTheirOrderAndSwapWithTheSides) {
  const synthetic::Played walker = synthetic::Walked(2, {.count = 2});
  const ComparedMotion plan = ComparedPlan(walker.model, walker.plan, "plan"),
                       log = ComparedLog(walker.model, walker.log, "log");
  SharedTime shared = SharedEvery(0.1, 12);
  shared.joints = {{"left_z", 2, 2}, {"right_x", 3, 3}};
  const std::vector<ComparedSeries> ab = SeriesOf(plan, log, shared), ba = SeriesOf(log, plan, shared);
  ASSERT_EQ(ab.size(), 3U * 2U + 4U + 3U + 2U);
  EXPECT_EQ(ab[1].quantity, "speed of left_z");
  EXPECT_EQ(ab[3].quantity, "position of right_x");
  EXPECT_EQ(ab[3].unit, "m");
  EXPECT_EQ(ab[5].unit, "N");
  EXPECT_EQ(ab[9].quantity, "attitude of the base");
  EXPECT_EQ(ab[13].quantity, "x of the zero-moment point");
  for (std::size_t i = 0; i < ab.size(); ++i) {
    ASSERT_EQ(ab[i].a.size(), shared.time_s.size());
    if (i == 9) continue;  // an angle is between the two
    for (std::size_t k = 0; k < ab[i].a.size(); ++k) {
      EXPECT_TRUE(ab[i].a[k] == ba[i].b[k] || (std::isnan(ab[i].a[k]) && std::isnan(ba[i].b[k]))) << ab[i].quantity;
    }
  }
  EXPECT_NEAR(ab[6].a[11], ab[10].a[11], 1e-9) << "the legs weigh nothing: the centre of mass is in the base";
}

}  // namespace
}  // namespace gaitwright
