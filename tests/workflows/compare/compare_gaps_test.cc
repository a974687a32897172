// SPDX-License-Identifier: BSD-3-Clause
// Missing rows or joints of a log do not count as differences.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/playback/played.h"
#include "workflows/compare/compare_motions.h"
#include "workflows/compare/comparison_text.h"

namespace gaitwright {
namespace {

synthetic::Played LongWalker() { return synthetic::Walked(2, {.count = 8}); }

ComparedMotion PlanWithGapsSide(const synthetic::Played& walker) {
  return ComparedPlan(walker.model, walker.plan, "plan.json");
}

/// The plan as an external table, without the rows between two times of the plan's clock.
MotionTable TableWithout(const synthetic::Played& walker, const TimeGap& gap, double clock_offset_s = 0.0) {
  const MotionRows rows = RowsOfPlan(walker.model, walker.plan, 200.0);
  MotionTable table;
  for (std::size_t k = 0; k < rows.time_s.size(); ++k) {
    if (rows.time_s[k] > gap.start_s && rows.time_s[k] < gap.end_s) continue;
    table.time_s.push_back(rows.time_s[k] + clock_offset_s);
    table.q.emplace_back(rows.q[k].tail(6));
    table.contact.push_back(rows.contact[k]);
  }
  return table;
}

ComparedMotion Side(const synthetic::Played& walker, const MotionTable& table) {
  return ComparedTable(walker.model, table, "robot.csv");
}

bool NotesOfGaps(const MotionComparison& c, const std::string& part) {
  return std::any_of(c.notes.begin(), c.notes.end(),
                     [&](const std::string& note) { return synthetic::Says(note, part); });
}

const TimeGap kGaps[] = {{0.8, 1.8}, {1.0, 2.0}, {0.5, 2.5}, {0.01, 2.0}};

TEST(CompareGaps, DoNotMoveTheClockAndAreNoDifference) {
  const synthetic::Played walker = LongWalker();
  ASSERT_GT(walker.plan.duration_s(), 4.0) << "something is left of it";
  for (const TimeGap& gap : kGaps) {
    for (const double clock_offset_s : {0.0, 37.25}) {
      SCOPED_TRACE(testing::Message() << gap.start_s << " to " << gap.end_s << ", ahead by " << clock_offset_s);
      const ComparedMotion plan = PlanWithGapsSide(walker),
                           table = Side(walker, TableWithout(walker, gap, clock_offset_s));
      for (const bool turned : {false, true}) {
        const MotionComparison c = turned ? CompareMotions(table, plan) : CompareMotions(plan, table);
        EXPECT_EQ(c.aligned_by, "best");
        EXPECT_NEAR(c.offset_s, turned ? -clock_offset_s : clock_offset_s, 1e-3);
        EXPECT_GT(c.best_offset->agreement, 0.99);
        EXPECT_TRUE(c.same()) << FirstDifferenceText(c);
        EXPECT_TRUE(NotesOfGaps(c, "'robot.csv', rows are missing: no row for "));
      }
    }
  }
}

TEST(CompareGaps, OfTwoTablesNothingIsComparedInTheGapsOfEither) {
  const synthetic::Played walker = LongWalker();
  const ComparedMotion whole = Side(walker, TableWithout(walker, {})),
                       early = Side(walker, TableWithout(walker, kGaps[0])),
                       late = Side(walker, TableWithout(walker, {2.4, 3.0}));
  EXPECT_FALSE(NotesOfGaps(CompareMotions(whole, whole), "rows are missing"));
  const int all = CompareMotions(whole, whole).samples;
  const MotionComparison one = CompareMotions(whole, early), two = CompareMotions(early, late);
  EXPECT_EQ(one.samples, early.rows.size());
  EXPECT_EQ(two.samples, early.rows.size() + late.rows.size() - all);
  for (const MotionComparison& c : {one, two}) {
    EXPECT_NEAR(c.offset_s, 0.0, 1e-3);
    EXPECT_TRUE(c.same()) << FirstDifferenceText(c);
  }
}

TEST(CompareGaps, OfALogOfOursToo) {
  const synthetic::Played walker = LongWalker();
  synthetic::Played cut = walker;
  std::erase_if(cut.log.samples, [](const LogSample& s) { return s.time_s > 0.01 && s.time_s < 1.99; });
  const MotionComparison c =
      CompareMotions(PlanWithGapsSide(walker), ComparedLog(cut.model, cut.log, "log.json"), {.align = "best"});
  EXPECT_NEAR(c.offset_s, 0.0, 1e-3);
  EXPECT_TRUE(c.same()) << FirstDifferenceText(c);
  EXPECT_TRUE(NotesOfGaps(c, "'log.json', rows are missing"));
}

TEST(CompareGaps, WhatDiffersOutsideOfThemIsReported) {
  const synthetic::Played walker = LongWalker();
  MotionTable table = TableWithout(walker, kGaps[1]);
  const auto first = std::find_if(table.time_s.begin(), table.time_s.end(), [](double t) { return t > 1.9; });
  for (auto k = static_cast<std::size_t>(first - table.time_s.begin()); k < table.q.size(); ++k) table.q[k][3] += 0.05;
  const MotionComparison c = CompareMotions(PlanWithGapsSide(walker), Side(walker, table));
  ASSERT_FALSE(c.same());
  EXPECT_EQ(c.in_order.front().quantity, "position of right_x");
  EXPECT_DOUBLE_EQ(c.in_order.front().time_s, *first);
}

TEST(CompareGaps, ASpeedBesideOneIsWorkedOutFromItsOwnSide) {
  const synthetic::Played walker = LongWalker();
  MotionTable table;
  for (int k = 0; k < 20; ++k) {
    const bool behind = k >= 10;
    table.time_s.push_back(0.01 * k + (behind ? 1.0 : 0.0));
    table.q.push_back(VectorX::Constant(6, behind ? 5.0 : 0.02 * k));
  }
  const ComparedMotion motion = Side(walker, table);
  EXPECT_NEAR(motion.rows.v[9][6], 2.0, 1e-9) << "the last row before";
  EXPECT_NEAR(motion.rows.v[10][6], 0.0, 1e-9) << "the first row behind";
  EXPECT_NEAR(NoiseGain(table.time_s, 0.09, motion.longest_step_s), std::sqrt(2.0) / 0.01, 1e-6);
}

TEST(CompareGaps, AJointThatIsLackingIsNamedAndTheOthersAreCompared) {
  const synthetic::Played walker = LongWalker();
  MotionTable table = TableWithout(walker, {});
  for (VectorX& q : table.q) q[3] = NAN;
  const MotionComparison c = CompareMotions(PlanWithGapsSide(walker), Side(walker, table));
  EXPECT_TRUE(c.same()) << FirstDifferenceText(c);
  EXPECT_EQ(c.joints.size(), 5U);
  for (const JointDifference& joint : c.joints) EXPECT_EQ(joint.position.samples, c.samples) << joint.joint;
  EXPECT_EQ(c.joints_only_a, std::vector<std::string>{"right_x"});
  EXPECT_TRUE(c.joints_only_b.empty());
  EXPECT_TRUE(NotesOfGaps(c, "'robot.csv' lacks 1 of 6 joints")) << ComparisonText(c, {});
  EXPECT_TRUE(synthetic::Says(ComparisonText(c, {}), "only in A: right_x"));
}

}  // namespace
}  // namespace gaitwright
