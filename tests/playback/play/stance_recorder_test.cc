// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "playback/play/stance_recorder_internal.h"

namespace gaitwright::playing {
namespace {

constexpr double kStep = 0.001, kWeight = 100.0;

FootContact Touch(double normal_n) {
  FootContact contact;
  contact.touching = normal_n > 0.0;
  contact.normal_n = normal_n;
  contact.tangential_n = 0.4 * normal_n;
  contact.friction = 0.8;
  contact.slide_m = 1e-5;
  contact.speed_m_s = 0.3;
  contact.penetration_m = 1e-6 * normal_n;
  return contact;
}

/// One foot that carries force in the steps [from, to).
std::vector<StanceRecord> Record(const std::vector<std::pair<int, int>>& touches, int steps, double normal_n = 50.0) {
  StanceRecorder recorder(1, kWeight, kStep, 0.005);
  for (int k = 0; k < steps; ++k) {
    bool touching = false;
    for (const auto& [from, to] : touches) touching = touching || (k >= from && k < to);
    recorder.Add(k * kStep, {Touch(touching ? normal_n : 0.0)});
  }
  return recorder.Finish(steps * kStep);
}

TEST(StanceRecorder, TellsTouchDownAndLiftOff) {
  const auto stances = Record({{100, 300}, {500, 800}}, 1000);
  ASSERT_EQ(stances.size(), 2U);
  EXPECT_NEAR(stances[0].touchdown_s, 0.1, 1e-12);
  EXPECT_NEAR(stances[0].liftoff_s, 0.3, 1e-12);
  EXPECT_NEAR(stances[1].touchdown_s, 0.5, 1e-12);
  EXPECT_NEAR(stances[1].liftoff_s, 0.8, 1e-12);
  EXPECT_EQ(stances[0].touchdown_speed_m_s, 0.3);
  EXPECT_NEAR(stances[0].slip_m, 200 * 1e-5, 1e-12);
  EXPECT_NEAR(stances[0].friction_use_max, 0.5, 1e-12);
  EXPECT_NEAR(stances[0].penetration_m, 5e-5, 1e-15);
}

TEST(StanceRecorder, ClosesFlickerButKeepsShortTouches) {
  const auto flicker = Record({{100, 200}, {214, 300}}, 500);
  ASSERT_EQ(flicker.size(), 1U);
  EXPECT_NEAR(flicker[0].liftoff_s, 0.3, 1e-12);
  EXPECT_EQ(Record({{100, 200}, {216, 300}}, 500).size(), 2U);
  const auto scuff = Record({{100, 101}}, 500);
  ASSERT_EQ(scuff.size(), 1U);
  EXPECT_NEAR(scuff[0].liftoff_s - scuff[0].touchdown_s, kStep, 1e-12);
}

TEST(StanceRecorder, AStanceAtTheEndEndsWithTheLog) {
  const auto stances = Record({{100, 1000}}, 500);
  ASSERT_EQ(stances.size(), 1U);
  EXPECT_NEAR(stances[0].liftoff_s, 0.5, 1e-12);
}

TEST(StanceRecorder, SlipCountsUnderLoadOnly) {
  EXPECT_EQ(Record({{100, 300}}, 500, 1.0)[0].slip_m, 0.0);
  EXPECT_EQ(Record({{100, 300}}, 500, 1.0)[0].friction_use_max, 0.0);
}

TEST(StanceRecorder, PeaksAreLowPassed) {
  const double long_push = Record({{100, 300}}, 500)[0].peak_normal_n, tap = Record({{100, 101}}, 500)[0].peak_normal_n;
  EXPECT_NEAR(long_push, 50.0, 0.1);
  EXPECT_LT(tap, 10.0);
  EXPECT_GT(tap, 5.0);
}

}  // namespace
}  // namespace gaitwright::playing
