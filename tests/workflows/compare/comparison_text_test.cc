// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/compare/comparison_text.h"

#include <gtest/gtest.h>

#include "tests/playback/played.h"

namespace gaitwright {
namespace {

using synthetic::Says;

FirstDifference DifferenceAt(double time_s, const std::string& quantity) {
  return {quantity, "rad", time_s, 0.1, 0.25, 0.05};
}

MotionComparison MadeUpComparison(int differences) {
  MotionComparison c;
  c.name_a = "a.json";
  c.name_b = "b.csv";
  c.kind_a = "plan";
  c.kind_b = "csv";
  c.robot_a = c.robot_b = "a1";
  c.aligned_by = "start";
  c.offset_s = 0.5;
  c.samples = 100;
  c.end_s = 2.0;
  for (int k = 0; k < differences; ++k)
    c.in_order.push_back(DifferenceAt(0.1 * (k + 1), "quantity " + std::to_string(k)));
  return c;
}

TEST(ComparisonTexts, TheFirstDifferenceIsSaidWithBothValuesUnitAndTolerance) {
  EXPECT_EQ(FirstDifferenceText(MadeUpComparison(2)),
            "quantity 0 differs first, at 0.100 s: 0.1 against 0.25 rad (tolerance 0.05)");
  MotionComparison contact = MadeUpComparison(0);
  contact.in_order = {{"contact of FL", "1", 1.5, 1.0, -0.0, 0.0}};
  EXPECT_EQ(FirstDifferenceText(contact), "contact of FL differs first, at 1.500 s: 1 against 0");
  EXPECT_EQ(FirstDifferenceText(MadeUpComparison(0)), "equal: all differences are within tolerance");
}

TEST(ComparisonTexts, TheFirstEightAreListedInOrderAndTheOthersCounted) {
  const std::string one = ComparisonText(MadeUpComparison(1), {}), eight = ComparisonText(MadeUpComparison(8), {}),
                    eleven = ComparisonText(MadeUpComparison(11), {});
  EXPECT_FALSE(Says(one, "in order of time"));
  EXPECT_TRUE(Says(eight, "quantity 7"));
  EXPECT_FALSE(Says(eight, "more\n"));
  EXPECT_TRUE(Says(eleven, "  and 3 more\n"));
  EXPECT_FALSE(Says(eleven, "quantity 8"));
}

TEST(ComparisonTexts, TheHeadSaysWhatAndHowClocksWereAligned) {
  MotionComparison c = MadeUpComparison(0);
  std::string text = ComparisonText(c, {});
  EXPECT_TRUE(Says(text, "A  plan of a1: a.json\nB  csv of a1: b.csv\n")) << text;
  EXPECT_TRUE(Says(text, "clocks aligned by start, B +0.5000 s")) << text;
  EXPECT_FALSE(Says(text, "correlation"));
  c.best_offset = ClockOffset{0.52, 0.875};
  EXPECT_TRUE(Says(ComparisonText(c, {}), "would be +0.5200 s ahead (correlation 0.8750)"));
  c.aligned_by = "best";
  text = ComparisonText(c, {});
  EXPECT_FALSE(Says(text, "would be")) << text;
  EXPECT_TRUE(Says(text, "0.8750 (1 is identical)")) << text;
}

TEST(ComparisonTexts, JointsBeyondTheirToleranceAreStarredAndMissingFiguresDashed) {
  MotionComparison c = MadeUpComparison(0);
  JointDifference joint{"knee", {}, {}, {}};
  joint.position = {
      .quantity = "position of knee", .unit = "rad", .samples = 3, .rms = 0.01, .largest = 0.5, .at_s = 1.0};
  joint.speed = joint.position;
  joint.speed.first_s = 0.75;
  c.joints = {joint};
  c.joints_only_b = {"wing_1", "wing_2"};
  const std::string text = ComparisonText(c, {});
  EXPECT_TRUE(Says(text, " 0.01 (0.5 at 1.00)")) << text;
  EXPECT_TRUE(Says(text, "*0.01 (0.5 at 1.00)")) << text;
  EXPECT_TRUE(Says(text, " -\n")) << "no torque is known";
  EXPECT_TRUE(Says(text, "only in B: wing_1, wing_2\n")) << text;
  EXPECT_FALSE(Says(text, "only in A")) << text;
}

TEST(ComparisonTexts, MetricsSayWhichSideFails) {
  const auto line = [](bool a, bool b) {
    const MetricPair metric{"slip_m", "m", 0.01, std::nullopt, 0.02, a, b, true};
    return ComparisonText(MadeUpComparison(0), {metric});
  };
  EXPECT_TRUE(Says(line(true, false), "m  B fails\n"));
  EXPECT_TRUE(Says(line(false, true), "m  A fails\n"));
  EXPECT_TRUE(Says(line(false, false), "m  both fail\n"));
  EXPECT_FALSE(Says(line(true, true), "fail"));
  EXPECT_TRUE(Says(line(true, true), "* slip_m"));
}

TEST(ComparisonTexts, OptionsThatOneSideAloneHasAreFoldedByGroup) {
  const FoldedWords folded = Folded({{"speed", "1", "2"},
                                     {"swing.height_m", "0.1", "", 'a'},
                                     {"swing.time_s", "0.4", "", 'a'},
                                     {"terrain", "flat", "", 'a'},
                                     {"swing.height_m", "", "0.2", 'b'}});
  ASSERT_EQ(folded.each.size(), 1U);
  EXPECT_EQ(folded.each[0].key, "speed");
  EXPECT_EQ(folded.only_a, "swing.*, terrain");
  EXPECT_EQ(folded.only_b, "swing.*");
  EXPECT_TRUE(Folded({}).each.empty());
}

TEST(ComparisonTexts, FeetAreLateInMillisecondsWithASign) {
  MotionComparison c = MadeUpComparison(0);
  FootDifference foot;
  foot.foot = "FL";
  foot.stances_a = 4;
  foot.stances_b = 3;
  foot.unmatched = 1;
  foot.timing.samples = 6;
  foot.timing.rms = 0.0125;
  foot.timing.largest = -0.025;
  c.feet = {foot};
  const std::string text = ComparisonText(c, {});
  EXPECT_TRUE(Says(text, "12.5")) << text;
  EXPECT_TRUE(Says(text, "-25.0")) << text;
}

TEST(ComparisonTexts, ReportsAreEqualOrNotAndHaveTheirScores) {
  ReportComparison c;
  c.name_a = "a.json";
  c.name_b = "b.json";
  c.score_a = 71.25;
  c.score_b = 60.0;
  EXPECT_TRUE(Says(ComparisonText(c), "equal: all differences"));
  c.words = {{"verdict", "pass", ""}};
  const std::string text = ComparisonText(c);
  EXPECT_TRUE(Says(text, "different;")) << text;
  EXPECT_TRUE(Says(text, "against 60.0")) << text;
  EXPECT_TRUE(Says(text, "verdict: pass against -")) << text;
}

}  // namespace
}  // namespace gaitwright
