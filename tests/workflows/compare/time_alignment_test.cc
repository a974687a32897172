// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/compare/time_alignment.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/playback/synthetic.h"

namespace gaitwright {
namespace {

/// A biped with one joint that moves around a given time, with its speeds.
ComparedMotion MoveAbout(double middle_s, double size = 1.0, double start_s = 0.0, double end_s = 3.0) {
  constexpr double kWidth = 0.15;  // [s]
  MotionTable table;
  table.format = MotionFormat::kCsv;
  for (double t = start_s; t <= end_s + 1e-9; t += 0.005) {
    const double u = (t - middle_s) / kWidth, bump = size * std::exp(-0.5 * u * u);
    VectorX q = VectorX::Zero(6), v = VectorX::Zero(6);
    q[1] = bump;
    v[1] = -u / kWidth * bump;
    table.time_s.push_back(t);
    table.q.push_back(q);
    table.v.push_back(v);
  }
  return ComparedTable(synthetic::Robot(2, FootType::kSphere), table, "move.csv");
}

const std::vector<NamedPair> kMovingJoint = {{"left_y", 1, 1}};

TEST(TimeAlignment, CommonNamesAreInTheOrderOfTheFirst) {
  const std::vector<NamedPair> common = CommonNames({"c", "a", "x", "b"}, {"a", "b", "c", "d"});
  ASSERT_EQ(common.size(), 3U);
  EXPECT_EQ(common[0].name, "c");
  EXPECT_EQ(common[0].a, 0);
  EXPECT_EQ(common[0].b, 2);
  EXPECT_EQ(common[2].name, "b");
  EXPECT_EQ(common[2].a, 3);
  EXPECT_EQ(common[2].b, 1);
  EXPECT_TRUE(CommonNames({"a"}, {}).empty());
}

TEST(TimeAlignment, AMoveThatComesLaterIsFoundToATenthOfAMillisecond) {
  for (const double late_s : {0.0, 0.25, -0.1537, 0.4004}) {
    const auto offset = BestOffset(MoveAbout(1.5), MoveAbout(1.5 + late_s), kMovingJoint);
    ASSERT_TRUE(offset) << late_s;
    EXPECT_NEAR(offset->offset_s, late_s, 1.5e-4);
    EXPECT_GT(offset->agreement, 0.999);
  }
}

TEST(TimeAlignment, SwappedSidesHaveTheOppositeOffsetAndTheSameAgreement) {
  const ComparedMotion a = MoveAbout(1.4), b = MoveAbout(1.65, 0.6);
  const auto ab = BestOffset(a, b, kMovingJoint), ba = BestOffset(b, a, kMovingJoint);
  ASSERT_TRUE(ab && ba);
  EXPECT_NEAR(ab->offset_s, -ba->offset_s, 2e-4);
  EXPECT_NEAR(ab->agreement, ba->agreement, 1e-3);
}

/// A motion with k times the amplitude has the agreement 2 k / (1 + k^2).
TEST(TimeAlignment, AMotionOfAnotherSizeAgreesLess) {
  for (const double k : {0.5, 2.0}) {
    const auto offset = BestOffset(MoveAbout(1.5), MoveAbout(1.7, k), kMovingJoint);
    ASSERT_TRUE(offset);
    EXPECT_NEAR(offset->agreement, 2.0 * k / (1.0 + k * k), 1e-3);
    EXPECT_NEAR(offset->offset_s, 0.2, 2e-3) << "rows are 5 ms apart, and between them a motion is a little smaller";
  }
}

TEST(TimeAlignment, AClockThatBeginsElsewhereIsPartOfTheOffset) {
  const auto offset = BestOffset(MoveAbout(1.5), MoveAbout(101.5, 1.0, 100.0, 103.0), kMovingJoint);
  ASSERT_TRUE(offset);
  EXPECT_NEAR(offset->offset_s, 100.0, 2e-4);
}

TEST(TimeAlignment, APieceIsFoundInTheWhole) {
  const auto offset = BestOffset(MoveAbout(1.5), MoveAbout(0.5, 1.0, 0.0, 1.0), kMovingJoint);
  ASSERT_TRUE(offset);
  EXPECT_NEAR(offset->offset_s, -1.0, 2e-4);
}

TEST(TimeAlignment, WithoutAJointThatMovesInBothThereIsNone) {
  EXPECT_FALSE(BestOffset(MoveAbout(1.5), MoveAbout(1.5, 0.0), kMovingJoint)) << "one rests";
  EXPECT_FALSE(BestOffset(MoveAbout(1.5), MoveAbout(1.5), {{"left_x", 0, 0}})) << "the joint that both have rests";
  EXPECT_FALSE(BestOffset(MoveAbout(1.5), MoveAbout(1.5), {}));
}

}  // namespace
}  // namespace gaitwright
