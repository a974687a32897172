// SPDX-License-Identifier: BSD-3-Clause
// The plots of trials: places of pushes, gates and scores.
#include <gtest/gtest.h>

#include "playback/report/trials_page.h"
#include "tests/playback/report/svg_marks.h"
#include "tests/playback/trials/made_outcomes.h"
#include "tests/playback/xml_check.h"

namespace gaitwright {
namespace {

Plot TrialPlotOf(const RobustnessReport& report, const std::string& name) {
  for (const Plot& plot : TrialPlots(report)) {
    if (plot.name == name) return plot;
  }
  ADD_FAILURE() << "no plot is called " << name;
  return {};
}

TEST(TrialsPlots, TheLegendHasNoLineThatIsNotDrawn) {
  const std::string page = TrialsPage(ReduceTrials(made::Subject(), made::Outcomes(40, 1000.0)));
  EXPECT_NE(page.find(">largest survived<"), std::string::npos);
  EXPECT_EQ(page.find("smallest fatal"), std::string::npos) << "no push was";
}

TEST(TrialsPlots, SaysOfSurvivalWhatIsDrawn) {
  const auto page = [](int trials) { return TrialsPage(ReduceTrials(made::Subject(), made::Outcomes(trials, 20.0))); };
  const std::string line = "the line is the share of each group that survived",
                    legend = ">share in groups of equal size<";
  EXPECT_NE(page(20).find(line), std::string::npos);
  EXPECT_NE(page(20).find(legend), std::string::npos);
  const std::string few = page(19);
  ASSERT_NE(few.find("id=\"survival_by_cause\""), std::string::npos);
  EXPECT_EQ(few.find(line), std::string::npos);
  EXPECT_EQ(few.find(legend), std::string::npos);
  EXPECT_NE(few.find("Each mark is a trial"), std::string::npos);
  EXPECT_NE(few.find("need 20 trials"), std::string::npos);
}

TEST(TrialsPlots, ComeInTheirOrderAndAreWellFormed) {
  std::vector<std::string> names;
  for (const Plot& plot : TrialPlots(ReduceTrials(made::Subject(), made::Outcomes(120, 25.0)))) {
    names.push_back(plot.name);
    EXPECT_EQ(XmlFault(plot.svg), "") << plot.name;
  }
  EXPECT_EQ(names, (std::vector<std::string>{"pushes", "survival_by_cause", "gates", "scores"}));
  EXPECT_TRUE(TrialPlots(ReduceTrials(made::Subject(), {})).empty());
}

// Each path goes from left to right without going back, and up: smaller is higher in SVG.
TEST(TrialsPlots, ScoresAreSortedWhateverTheOrderOfTheTrials) {
  RobustnessReport report = ReduceTrials(made::Subject(), made::Outcomes(40, 25.0));
  const std::string svg = TrialPlotOf(report, "scores").svg;
  const auto line = svg_marks::Paths(svg, "com measured").at(0);
  ASSERT_GT(line.size(), 2U);
  for (std::size_t i = 1; i < line.size(); ++i) {
    EXPECT_GT(line[i].x(), line[i - 1].x());
    EXPECT_LE(line[i].y(), line[i - 1].y());
  }
  EXPECT_LT(line.back().y(), line.front().y());
  std::reverse(report.outcomes.begin(), report.outcomes.end());
  EXPECT_EQ(TrialPlotOf(report, "scores").svg, svg);
}

// The axis goes from 0 to twice the limit.
TEST(TrialsPlots, GatesAreSharesOfTheirLimitAndEndAtTwiceIt) {
  RobustnessReport report = ReduceTrials(made::Subject(), made::Outcomes(20, 25.0));
  report.metrics.resize(2);
  MetricSpread& goal = report.metrics.at(1);
  ASSERT_EQ(goal.key, "goal_error_m");
  ASSERT_EQ(goal.limit, 0.05);
  goal.lowest = 0.0;
  goal.p05 = 0.0125;
  goal.median = 0.025;
  goal.p95 = 0.05;
  goal.highest = 10.0;
  const std::string svg = TrialPlotOf(report, "gates").svg;
  EXPECT_EQ(svg.find(">fell<"), std::string::npos) << "a share of a limit of 0 means nothing";
  EXPECT_NE(svg.find(">goal_error_m<"), std::string::npos);
  const svg_marks::Box axes = svg_marks::Boxes(svg, "frame").at(0);
  const svg_marks::Box all = svg_marks::Boxes(svg, "support bar-planned").at(0);
  const svg_marks::Box most = svg_marks::Boxes(svg, "com bar-measured").at(0);
  const double width = axes.right - axes.left;
  EXPECT_NEAR(all.left, axes.left, 0.2);
  EXPECT_NEAR(all.right, axes.right, 0.2) << "clipped at twice the limit";
  EXPECT_NEAR(most.left, axes.left + 0.125 * width, 0.2);
  EXPECT_NEAR(most.right, axes.left + 0.5 * width, 0.2);
  EXPECT_NEAR(svg_marks::Dots(svg, "zmp").at(0).x(), axes.left + 0.25 * width, 0.2);
}

TEST(TrialsPlots, PushesAreSeenFromAboveWithForwardUp) {
  RobustnessReport report = ReduceTrials(made::Subject(), made::Outcomes(60, 25.0));
  const auto pushed = [&](double forward_n, double left_n) {
    PushRecord push = report.pushes.at(0);
    push.forward_n = forward_n;
    push.left_n = left_n;
    push.up_n = 0.0;
    push.outcome = PushRecord::Outcome::kRecovered;
    RobustnessReport one = report;
    one.pushes = {push};
    one.push_bins = PushBins(one.pushes);
    const std::string svg = TrialPlotOf(one, "pushes").svg;
    const svg_marks::Box axes = svg_marks::Boxes(svg, "frame").at(0);
    const Vector2 middle(0.5 * (axes.left + axes.right), 0.5 * (axes.top + axes.bottom));
    return Vector2(svg_marks::Dots(svg, "foot").at(0) - middle);
  };
  const Vector2 forward = pushed(20.0, 0.0), back = pushed(-20.0, 0.0), left = pushed(0.0, 20.0);
  EXPECT_LT(forward.y(), -10.0);
  EXPECT_NEAR(forward.x(), 0.0, 1.0);
  EXPECT_GT(back.y(), 10.0);
  EXPECT_LT(left.x(), -10.0);
  EXPECT_NEAR(left.y(), 0.0, 1.0);
  EXPECT_NEAR(left.norm(), forward.norm(), 1.0) << "to scale";
}

}  // namespace
}  // namespace gaitwright
