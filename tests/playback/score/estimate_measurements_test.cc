// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "kinematics/spatial/rotation.h"
#include "playback/report/plots.h"
#include "playback/score/measurements.h"
#include "playback/score/report_text.h"
#include "tests/playback/played.h"

namespace gaitwright {
namespace {

/// A log whose estimates have errors: a turn about the vertical, and the given ones.
synthetic::Played Off(const Vector3& place_W, double tilt_rad, const Vector3& velocity_B) {
  synthetic::Played played = synthetic::Walked(4);
  for (LogSample& sample : played.log.samples) {
    const Matrix3 R_true = BaseRotation(sample.q);
    const Matrix3 R_WB = YawRotation(0.3) * R_true * RotationExp(tilt_rad * Vector3::UnitX());
    sample.estimate = BaseEstimate{};
    sample.estimate->p_WB = sample.q.head<3>() + place_W;
    sample.estimate->R_WB = Quaternion(R_WB);
    sample.estimate->v_WB = R_WB * (R_true.transpose() * sample.v.head<3>() + velocity_B);
  }
  return played;
}

TEST(EstimateMeasurements, TellHowFarTheEstimateWasFromTheTruth) {
  const synthetic::Played played = Off({0.03, -0.04, 0.02}, 0.1, {0.0, 0.06, 0.08});
  EXPECT_NEAR(played.Value("estimate_drift_m"), 0.05, 1e-12);
  EXPECT_NEAR(played.Value("estimate_height_m"), 0.02, 1e-12);
  EXPECT_NEAR(played.Value("estimate_tilt_rad"), 0.1, 1e-9) << "the heading does not count";
  EXPECT_NEAR(played.Value("estimate_heading_rad"), 0.3, 1e-9);
  EXPECT_NEAR(played.Value("estimate_velocity_m_s"), 0.1, 1e-9);
}

TEST(EstimateMeasurements, HaveHeadingsThatGoAroundTheCircle) {
  synthetic::Played played = Off(Vector3::Zero(), 0.0, Vector3::Zero());
  for (LogSample& sample : played.log.samples) {
    sample.q.segment<4>(3) = Quaternion(YawRotation(3.1)).coeffs();
    sample.estimate->R_WB = Quaternion(YawRotation(-3.1));
  }
  const EstimateError error = ErrorOf(played.log.samples.back());
  EXPECT_NEAR(error.heading_rad, 2.0 * std::numbers::pi - 6.2, 1e-9);
  EXPECT_NEAR(error.tilt_rad, 0.0, 1e-9);
}

TEST(EstimateMeasurements, NeitherScoreNorFailAndAreAbsentWithoutAnEstimate) {
  const synthetic::Played bad = Off({3.0, 4.0, 2.0}, 1.0, {1.0, 1.0, 1.0}), none = synthetic::Walked(4);
  const StabilityReport with = Score(bad.model, bad.plan, bad.log), without = Score(none.model, none.plan, none.log);
  EXPECT_EQ(with.pass, without.pass);
  EXPECT_EQ(with.score, without.score);
  EXPECT_FALSE(without.At("estimate_drift_m").value.has_value());
  EXPECT_EQ(without.At("estimate_drift_m").not_applied, "the controller had the base's true state");
  EXPECT_TRUE(synthetic::Says(ReportText(with), "estimate_drift_m"));
  EXPECT_FALSE(synthetic::Says(ReportText(without), "estimate_"));
}

TEST(EstimateMeasurements, ArePlottedWhereThereAreAny) {
  const auto has = [](const synthetic::Played& played) {
    const std::vector<Plot> plots =
        MakePlots(played.model, played.plan, played.log, Score(played.model, played.plan, played.log));
    return std::any_of(plots.begin(), plots.end(), [](const Plot& plot) {
      return plot.name == "estimate_error" && plot.svg.find("Heading") != std::string::npos;
    });
  };
  EXPECT_TRUE(has(Off({0.01, 0.0, 0.0}, 0.1, Vector3::Zero())));
  EXPECT_FALSE(has(synthetic::Walked(4)));
}

}  // namespace
}  // namespace gaitwright
