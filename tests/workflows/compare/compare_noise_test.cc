// SPDX-License-Identifier: BSD-3-Clause
// Measurement noise does not count as a difference; a fault in a noisy log is found.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/playback/played.h"
#include "workflows/compare/compare_motions.h"
#include "workflows/compare/comparison_text.h"

namespace gaitwright {
namespace {

constexpr double kFault_s = 3.0;
constexpr int kFaulty = 3;  // right_x

/// The log of a robot that follows its plan.
struct Logger {
  double rate_hz = 200.0, clock_offset_s = 0.0;
  double noise_m = 0.0;           ///< standard deviation of positions
  double fault_m = 0.0;           ///< error of one joint from kFault_s on
  double step_m = 0.0;            ///< positions are rounded to multiples of it
  bool gives_speeds = false;      ///< the log has speeds, with separate noise
  double speed_noise_m_s = 0.05;  ///< standard deviation
};

synthetic::Played NoisyWalker() { return synthetic::Walked(2, {.count = 6}); }

ComparedMotion NoisyPlanSide(const synthetic::Played& walker) {
  return ComparedPlan(walker.model, walker.plan, "plan.json");
}

ComparedMotion RobotSide(const synthetic::Played& walker, const Logger& logger) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal(0.0, 1.0);
  const MotionRows rows = RowsOfPlan(walker.model, walker.plan, logger.rate_hz);
  MotionTable table;
  for (std::size_t k = 0; k < rows.time_s.size(); ++k) {
    table.time_s.push_back(rows.time_s[k] + logger.clock_offset_s);
    VectorX q = rows.q[k].tail(6), v = rows.v[k].tail(6);
    for (Eigen::Index d = 0; d < 6; ++d) {
      q[d] += logger.noise_m * normal(random);
      v[d] += logger.speed_noise_m_s * normal(random);
    }
    if (rows.time_s[k] > kFault_s - 1e-9) q[kFaulty] += logger.fault_m;
    if (logger.step_m > 0.0) q = logger.step_m * (q / logger.step_m).array().round();
    table.q.push_back(q);
    if (logger.gives_speeds) table.v.push_back(v);
  }
  return ComparedTable(walker.model, table, "robot.csv");
}

bool NotesOfNoise(const MotionComparison& c, const std::string& part) {
  return std::any_of(c.notes.begin(), c.notes.end(),
                     [&](const std::string& note) { return synthetic::Says(note, part); });
}

TEST(CompareNoise, OfARobotThatDoesAsPlannedIsNoDifference) {
  const synthetic::Played walker = NoisyWalker();
  const Logger at_200{.rate_hz = 200.0, .clock_offset_s = 37.25, .noise_m = 5e-4};
  Logger at_500 = at_200, rougher = at_200, with_speeds = at_200;
  at_500.rate_hz = 500.0;
  rougher.noise_m = 1e-3;
  with_speeds.gives_speeds = true;
  for (const Logger& logger : {at_200, at_500, rougher, with_speeds}) {
    const MotionComparison c = CompareMotions(NoisyPlanSide(walker), RobotSide(walker, logger));
    EXPECT_TRUE(c.same()) << FirstDifferenceText(c);
    EXPECT_NEAR(c.offset_s, 37.25, 0.015);
    for (const JointDifference& joint : c.joints) EXPECT_NEAR(joint.position.noise, logger.noise_m, 2e-4);
    EXPECT_FALSE(CompareMotions(NoisyPlanSide(walker), RobotSide(walker, logger), {.tolerance = 0.0}).same())
        << "without a tolerance nothing is let pass";
  }
}

TEST(CompareNoise, StepsOfEncodersAreNoDifference) {
  const synthetic::Played walker = NoisyWalker();
  const Logger logger{.clock_offset_s = 37.25, .step_m = 0.002};
  const ComparedMotion robot = RobotSide(walker, logger);
  EXPECT_NEAR(robot.ResolutionOf(kFaulty), 0.002, 1e-12);
  const MotionComparison c = CompareMotions(NoisyPlanSide(walker), robot);
  EXPECT_TRUE(c.same()) << FirstDifferenceText(c);
  EXPECT_GE(c.joints[kFaulty].position.noise, 0.002 / std::sqrt(12.0) - 1e-12);
}

TEST(Resolution, IsTheStepThatPositionsAreMultiplesOf) {
  std::vector<double> steps, noisy, jump(100, 0.3), flaps(100, 0.3);
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0.0, 1e-4);
  for (int k = 0; k < 100; ++k) {
    steps.push_back(0.002 * std::round(std::max(0.0, 0.1 * std::sin(0.1 * k)) / 0.002));
    noisy.push_back(steps.back() + noise(random));
    if (k > 60) jump[static_cast<std::size_t>(k)] = 0.4;
    if (k % 4 < 2) flaps[static_cast<std::size_t>(k)] = 0.4;
  }
  EXPECT_NEAR(ResolutionOf(steps), 0.002, 1e-12);
  EXPECT_EQ(ResolutionOf(noisy), 0.0);
  EXPECT_EQ(ResolutionOf(jump), 0.0) << "a fault is no step of an encoder";
  EXPECT_EQ(ResolutionOf(flaps), 0.0);
  EXPECT_EQ(ResolutionOf({}), 0.0);
}

TEST(CompareNoise, AFaultIsNamedBeforeWhatNoiseAndDerivativesMakeOfIt) {
  const synthetic::Played walker = NoisyWalker();
  for (const double rate_hz : {200.0, 500.0}) {
    const MotionComparison c = CompareMotions(
        NoisyPlanSide(walker),
        RobotSide(walker, {.rate_hz = rate_hz, .clock_offset_s = -3.0017, .noise_m = 5e-4, .fault_m = 0.1}));
    ASSERT_FALSE(c.same());
    const FirstDifference& first = c.in_order.front();
    EXPECT_EQ(first.quantity, "position of right_x") << FirstDifferenceText(c);
    EXPECT_NEAR(first.time_s, kFault_s, 0.015);
    EXPECT_NEAR(first.b - first.a, 0.1, 0.02);
    EXPECT_FALSE(first.derived);
    for (const FirstDifference& one : c.in_order) EXPECT_TRUE(one.quantity.ends_with("right_x")) << one.quantity;
    ASSERT_EQ(c.in_order.size(), 2U);
    EXPECT_TRUE(c.in_order[1].derived);
    EXPECT_EQ(c.in_order[1].time_s, first.time_s) << "the jump of the position is what its speed jumps by";
  }
}

TEST(CompareNoise, AJumpOfAPositionDoesNotMoveTheClock) {
  const synthetic::Played walker = NoisyWalker();
  for (const double rate_hz : {200.0, 500.0, 1000.0}) {
    const Logger logger{.rate_hz = rate_hz, .clock_offset_s = 12.5, .fault_m = 0.4};
    const MotionComparison c = CompareMotions(NoisyPlanSide(walker), RobotSide(walker, logger));
    EXPECT_NEAR(c.offset_s, 12.5, 2e-3) << rate_hz;
  }
}

TEST(CompareNoise, WhatIsLetPassIsSaid) {
  const synthetic::Played walker = NoisyWalker();
  const ComparedMotion plan = NoisyPlanSide(walker);
  const Logger logger{.noise_m = 5e-4};
  const MotionComparison c = CompareMotions(plan, RobotSide(walker, logger));
  EXPECT_TRUE(NotesOfNoise(c, "speeds of B are computed from positions, whose noise")) << c.notes.size();
  EXPECT_TRUE(NotesOfNoise(c, "5 standard deviations"));
  EXPECT_NEAR(c.joints[0].speed.noise, 5e-4 * std::sqrt(0.5) / 0.005, 0.02);
  EXPECT_GT(c.joints[0].speed.tolerance, 5.0 * c.joints[0].speed.noise);
  EXPECT_TRUE(NotesOfNoise(CompareMotions(RobotSide(walker, logger), plan), "speeds of A are computed"));
  EXPECT_TRUE(
      NotesOfNoise(CompareMotions(RobotSide(walker, logger), RobotSide(walker, logger)), "speeds of A and B are"));
  Logger with_speeds = logger;
  with_speeds.gives_speeds = true;
  EXPECT_FALSE(NotesOfNoise(CompareMotions(plan, RobotSide(walker, with_speeds)), "are computed from positions"));
  const MotionComparison of_log = CompareMotions(plan, ComparedLog(walker.model, walker.log, "log.json"));
  EXPECT_FALSE(NotesOfNoise(of_log, "computed from positions"));
  for (const JointDifference& joint : of_log.joints)
    EXPECT_EQ(joint.position.noise, 0.0) << "of what we play there is none";
}

TEST(NoiseGain, IsThatOfCentralDifferencesAndTwiceThatAtAnEnd) {
  const std::vector<double> times = {1.0, 1.005, 1.01, 1.015, 1.02, 1.025};
  EXPECT_NEAR(NoiseGain(times, 1.0125), std::sqrt(0.5) / 0.005, 1e-6);
  EXPECT_NEAR(NoiseGain(times, 1.001), std::sqrt(2.0) / 0.005, 1e-6);
  EXPECT_NEAR(NoiseGain(times, 7.0), std::sqrt(2.0) / 0.005, 1e-6);
  EXPECT_EQ(NoiseGain({1.0}, 1.0), 0.0) << "one row has no speed";
}

TEST(NoiseGain, IsWhatNoiseComesOutWithBetweenUnevenRows) {
  const synthetic::Played walker = NoisyWalker();
  std::mt19937 random(11);
  std::normal_distribution<double> noise(0.0, 1e-3);
  MotionTable table;
  double time_s = 0.0;
  for (int k = 0; k < 2000; ++k) {
    table.time_s.push_back(time_s);
    time_s += k % 2 == 0 ? 0.004 : 0.006;
    VectorX q(6);
    for (double& x : q) x = noise(random);
    table.q.push_back(q);
  }
  const ComparedMotion side = ComparedTable(walker.model, table, "noise.csv");
  double sum = 0.0;
  for (std::size_t k = 1; k + 1 < side.rows.v.size(); ++k) sum += side.rows.v[k].tail(6).squaredNorm();
  const double measured = std::sqrt(sum / (6.0 * 1998.0)) / 1e-3, predicted = NoiseGain(table.time_s, 5.001);
  EXPECT_GT(predicted, 100.0);
  EXPECT_NEAR(measured / predicted, 1.0, 0.05);
}

}  // namespace
}  // namespace gaitwright
