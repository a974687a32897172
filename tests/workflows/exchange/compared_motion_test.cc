// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/exchange/compared_motion.h"

#include <gtest/gtest.h>

#include <cmath>

#include "kinematics/base/non_finite.h"
#include "kinematics/base/result.h"
#include "tests/playback/played.h"

namespace gaitwright {
namespace {

/// A table of the block biped whose joints follow `position(time, joint)`.
template <class Position>
MotionTable JointTable(const std::vector<double>& time_s, Position position) {
  MotionTable table;
  table.format = MotionFormat::kCsv;
  table.time_s = time_s;
  for (const double t : time_s) {
    VectorX q(6);
    for (int d = 0; d < 6; ++d) q[d] = position(t, d);
    table.q.push_back(q);
  }
  return table;
}

ComparedMotion ComparedBiped(const MotionTable& table) {
  return ComparedTable(synthetic::Robot(2, FootType::kSphere), table, "robot.csv");
}

std::string RefusalOfTable(const MotionTable& table) {
  try {
    ComparedBiped(table);
  } catch (const InvalidArgument& error) {
    return error.what();
  }
  return "nothing was refused";
}

const std::vector<double> kUnevenTimes = {0.0, 0.01, 0.015, 0.03, 0.034, 0.05};

TEST(ComparedMotion, ASpeedThatIsComputedIsExactForParabolas) {
  const auto rate = [](double t, int d) { return 0.3 * d - 4.0 * t; };
  const ComparedMotion motion =
      ComparedBiped(JointTable(kUnevenTimes, [](double t, int d) { return 0.1 + 0.3 * d * t - 2.0 * t * t; }));
  for (std::size_t k = 1; k + 1 < kUnevenTimes.size(); ++k) {
    for (int d = 0; d < 6; ++d) EXPECT_NEAR(motion.rows.v[k][6 + d], rate(kUnevenTimes[k], d), 1e-12) << k;
  }
  for (int d = 0; d < 6; ++d) {  // from the last two rows at an end
    EXPECT_NEAR(motion.rows.v.front()[6 + d], rate(0.005, d), 1e-12);
    EXPECT_TRUE(motion.derives_speed(d));
  }
  EXPECT_TRUE(std::isnan(motion.rows.v[2][0])) << "nothing is known of the base";
}

/// The noise of a speed is the root of the sum of squares of the contributions of the positions.
TEST(ComparedMotion, NoiseGainIsThatOfTheSpeedsThemselves) {
  std::vector<double> squared(kUnevenTimes.size(), 0.0);
  for (std::size_t j = 0; j < kUnevenTimes.size(); ++j) {
    const ComparedMotion impulse =
        ComparedBiped(JointTable(kUnevenTimes, [&](double t, int) { return t == kUnevenTimes[j] ? 1.0 : 0.0; }));
    for (std::size_t k = 0; k < squared.size(); ++k) squared[k] += std::pow(impulse.rows.v[k][6], 2);
  }
  for (std::size_t k = 0; k + 1 < kUnevenTimes.size(); ++k) {
    const double between_s = 0.5 * (kUnevenTimes[k] + kUnevenTimes[k + 1]);
    EXPECT_NEAR(NoiseGain(kUnevenTimes, between_s), std::sqrt(std::max(squared[k], squared[k + 1])), 1e-9) << k;
  }
  const std::vector<double> even = {0.0, 0.1, 0.2, 0.3, 0.4};
  EXPECT_NEAR(NoiseGain(even, 0.15), std::sqrt(0.5) / 0.1, 1e-12);
  EXPECT_NEAR(NoiseGain(even, 0.01), std::sqrt(2.0) / 0.1, 1e-12) << "twice as much at an end";
}

TEST(ComparedMotion, SpeedsOfTheFileAreKeptAndOnlyTheOthersComputed) {
  MotionTable table = JointTable({0.0, 0.01, 0.02}, [](double t, int) { return 2.0 * t; });
  for (int k = 0; k < 3; ++k) {
    table.v.emplace_back(VectorX::Constant(6, 7.0));
    table.v.back()[4] = kNaN;
  }
  const ComparedMotion motion = ComparedBiped(table);
  EXPECT_EQ(motion.rows.v[1][6 + 0], 7.0);
  EXPECT_NEAR(motion.rows.v[1][6 + 4], 2.0, 1e-12);
  EXPECT_FALSE(motion.derives_speed(0));
  EXPECT_TRUE(motion.derives_speed(4));
}

TEST(ComparedMotion, AJointThatTheFileLacksIsNotDerivedAndIsNoted) {
  const ComparedMotion motion =
      ComparedBiped(JointTable({0.0, 0.01, 0.02}, [](double t, int d) { return d == 3 ? kNaN : t; }));
  EXPECT_FALSE(motion.HasJoint(3));
  EXPECT_FALSE(motion.derives_speed(3));
  EXPECT_TRUE(motion.HasJoint(2));
  ASSERT_EQ(motion.notes.size(), 1U);
  EXPECT_TRUE(synthetic::Says(motion.notes[0], "'right_x'")) << motion.notes[0];
  EXPECT_TRUE(synthetic::Says(motion.notes[0], "1 of 6")) << motion.notes[0];
}

TEST(ComparedMotion, ContactsChangeHalfwayBetweenRows) {
  MotionTable table = JointTable({0.0, 0.1, 0.2, 0.3, 0.4}, [](double, int) { return 0.0; });
  table.contact = {0b01, 0b11, 0b10, 0b10, 0b11};
  const ComparedMotion motion = ComparedBiped(table);
  ASSERT_EQ(motion.stances.size(), 2U);
  ASSERT_EQ(motion.stances[0].size(), 2U);
  EXPECT_NEAR(motion.stances[0][0].start_s, 0.0, 1e-12);
  EXPECT_NEAR(motion.stances[0][0].end_s, 0.15, 1e-12);
  EXPECT_NEAR(motion.stances[0][1].start_s, 0.35, 1e-12);
  EXPECT_NEAR(motion.stances[0][1].end_s, 0.4, 1e-12);
  ASSERT_EQ(motion.stances[1].size(), 1U);
  EXPECT_NEAR(motion.stances[1][0].start_s, 0.05, 1e-12);
}

TEST(ComparedMotion, NothingIsKnownInsideAGapAndAllAtItsEnds) {
  std::vector<double> times;
  for (int k = 0; k < 40; ++k) times.push_back(0.005 * k + (k < 20 ? 0.0 : 1.0));
  const ComparedMotion motion = ComparedBiped(JointTable(times, [](double t, int) { return t; }));
  ASSERT_EQ(motion.gaps.size(), 1U);
  RowSample sample;
  SampleCompared(motion, 0.5, sample);
  EXPECT_TRUE(std::isnan(sample.q[7]) && std::isnan(sample.v[6]));
  for (const double end_s : {motion.gaps[0].start_s, motion.gaps[0].end_s}) {
    SampleCompared(motion, end_s, sample);
    EXPECT_NEAR(sample.q[7], end_s, 1e-12);
    EXPECT_NEAR(sample.v[6], 1.0, 1e-9) << "a line through the rows on its own side of the gap";
  }
}

TEST(ComparedMotion, RefusesTablesThatAreNoMotionOfTheRobot) {
  EXPECT_EQ(RefusalOfTable({}), "has no row");
  MotionTable table = JointTable({0.0, 0.01, 0.01}, [](double, int) { return 0.0; });
  EXPECT_TRUE(synthetic::Says(RefusalOfTable(table), "row 3")) << RefusalOfTable(table);
  table.time_s[2] = 0.02;
  for (VectorX& q : table.q) q.conservativeResize(5);
  EXPECT_TRUE(synthetic::Says(RefusalOfTable(table), "'block_biped'")) << RefusalOfTable(table);
  const std::string jump =
      RefusalOfTable(JointTable({0.0, 0.01, 0.02}, [](double t, int d) { return d == 2 && t > 0.015 ? 1e9 : 0.0; }));
  EXPECT_TRUE(synthetic::Says(jump, "'left_z'")) << jump;
  EXPECT_TRUE(synthetic::Says(jump, "row 2")) << jump;
}

TEST(ComparedMotion, AForeignTableThatIsRefusedNamesItsFile) {
  const RobotModel model = synthetic::Robot(2, FootType::kSphere);
  const Result<ComparedMotion> refused = CheckedTable(
      model, {}, JointTable({0.0, 0.01, 0.02}, [](double t, int) { return t > 0.015 ? 1e9 : 0.0; }), "a.csv");
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.failure().kind, FailureKind::kBadInput);
  EXPECT_EQ(refused.failure().code, FailureCode::kMotion);
  EXPECT_EQ(refused.failure().message.substr(0, 9), "'a.csv': ");
}

TEST(ComparedMotion, EncoderStepsAreFoundInRoundedPositionsAlone) {
  constexpr double kEncoder = 0.001;
  std::vector<double> smooth, rounded, jump(60, 0.0);
  for (int k = 0; k < 60; ++k) {
    smooth.push_back(0.1 * std::sin(0.1 * k));
    rounded.push_back(kEncoder * std::round(smooth.back() / kEncoder));
  }
  jump[30] = 1.0;
  EXPECT_NEAR(ResolutionOf(rounded), kEncoder, 1e-12);
  EXPECT_EQ(ResolutionOf(smooth), 0.0);
  EXPECT_EQ(ResolutionOf(jump), 0.0);
  EXPECT_EQ(ResolutionOf({rounded.begin(), rounded.begin() + 10}), 0.0) << "too few steps to tell";
  EXPECT_EQ(ResolutionOf({}), 0.0);
}

TEST(ComparedMotion, PlansAndLogsHaveTheirContactsAndTheAgeOfMeanTorques) {
  const synthetic::Played walker = synthetic::Walked(2, {.count = 2});
  const ComparedMotion plan = ComparedPlan(walker.model, walker.plan, "plan.json"),
                       log = ComparedLog(walker.model, walker.log, "log.json");
  EXPECT_EQ(plan.kind, ComparedKind::kPlan);
  EXPECT_EQ(log.kind, ComparedKind::kLog);
  EXPECT_FALSE(plan.foreign() || log.foreign());
  EXPECT_EQ(plan.torque_age_s, 0.0);
  EXPECT_NEAR(log.torque_age_s, 0.5 * synthetic::kStep, 1e-12);
  for (int foot = 0; foot < 2; ++foot)
    EXPECT_EQ(plan.stances[static_cast<std::size_t>(foot)], IntervalsOf(walker.plan.schedule, foot));
  EXPECT_TRUE(ComparedBiped(JointTable({0.0, 0.1}, [](double, int) { return 0.0; })).foreign());
}

}  // namespace
}  // namespace gaitwright
