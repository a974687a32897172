// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "playback/score/measurements.h"
#include "tests/playback/played.h"

namespace gaitwright {
namespace {

using synthetic::kStep;
using synthetic::Played;
using synthetic::Stood;
using synthetic::Walked;

Metric ContactMetric(const Played& c, const std::string& key) { return Score(c.model, c.plan, c.log).At(key); }

TEST(ContactMeasurements, WithoutStancesThereIsNothingToMeasure) {
  Played c = Walked();
  c.log.stances.clear();
  for (const char* key : {"slip_total_m", "slip_max_step_m", "penetration_max_m", "impact_max_n_per_mg",
                          "touchdown_speed_max_m_s", "friction_use_max"}) {
    EXPECT_FALSE(ContactMetric(c, key).value.has_value()) << key;
    EXPECT_FALSE(ContactMetric(c, key).not_applied.empty()) << key;
  }
}

TEST(ContactMeasurements, StancesThatBeginAfterTheFallDoNotCount) {
  Played c = Walked();
  for (std::size_t i = 0; i < c.log.stances.size(); ++i) c.log.stances[i].slip_m = std::pow(2.0, i) * 1e-3;
  const double between = 0.5 * (c.log.stances[3].touchdown_s + c.log.stances[4].touchdown_s);
  c.log.body_contacts = {{between, "trunk"}};
  EXPECT_NEAR(c.Value("slip_total_m"), 0.015, 1e-12) << "1 + 2 + 4 + 8 mm";
  const Metric largest = ContactMetric(c, "slip_max_step_m");
  EXPECT_NEAR(*largest.value, 0.008, 1e-12);
  EXPECT_DOUBLE_EQ(*largest.at_s, c.log.stances[3].touchdown_s);
}

TEST(ContactMeasurements, WhoOnlyStandsHasNoClearanceScuffsOrTimes) {
  for (const char* key : {"clearance_min_m", "scuffs", "contact_timing_error_max_s"}) {
    EXPECT_FALSE(ContactMetric(Stood(), key).value.has_value()) << key;
  }
}

TEST(ContactMeasurements, OnlyTheMiddleHalfOfASwingNeedsClearance) {
  const Played c = Walked();
  const double before = c.Value("clearance_min_m");
  const ContactPhase& swing = c.plan.schedule.phases[1];
  const auto lowered = [&](double share) {
    Played low = c;
    const double time_s = swing.start_s + share * (swing.end_s - swing.start_s);
    low.log.samples[static_cast<std::size_t>(std::lround(time_s / kStep))].q[9] -= 0.012;
    return low.Value("clearance_min_m");
  };
  for (const double share : {0.2, 0.8}) EXPECT_DOUBLE_EQ(lowered(share), before) << share;
  EXPECT_NEAR(lowered(0.25), before - 0.012, 1e-6) << "the middle half begins here";
}

TEST(ContactMeasurements, TheLargestTimingErrorIsFoundForBothSigns) {
  for (const double error_s : {0.02, -0.03}) {
    Played c = Walked();
    for (StanceRecord& stance : c.log.stances) {
      if (stance.touchdown_s < 1.0) continue;
      stance.touchdown_s += error_s;  // the first foot that touches down
      break;
    }
    EXPECT_NEAR(c.Value("contact_timing_error_max_s"), std::abs(error_s), 1e-9);
  }
  EXPECT_NEAR(Walked().Value("contact_timing_error_max_s"), 0.0, 1e-9);
}

TEST(ContactMeasurements, PlannedUseOfFrictionGoesWithItsInverse) {
  Played c = Walked();
  const double usual = c.Planned("friction_use_max");
  EXPECT_GT(usual, 0.01);
  c.plan.terrain = FlatTerrain(0.4);
  EXPECT_NEAR(c.Planned("friction_use_max"), 2.0 * usual, 1e-9);
  EXPECT_NEAR(Stood().Planned("friction_use_max"), 0.0, 1e-9) << "weight alone";
}

TEST(ContactMeasurements, AnImpactIsAShareOfTheWeight) {
  Played c = Walked();
  for (StanceRecord& stance : c.log.stances) stance.peak_normal_n = 40.0;
  c.log.stances[2].peak_normal_n = 10.0 * kGravity * 2.5;  // the robot has 10 kg
  EXPECT_NEAR(c.Value("impact_max_n_per_mg"), 2.5, 1e-12);
}

}  // namespace
}  // namespace gaitwright
