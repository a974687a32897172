// SPDX-License-Identifier: BSD-3-Clause
// The plot from above: which supports, footholds and paths are drawn.
#include <gtest/gtest.h>

#include "tests/playback/report/made_plots.h"
#include "tests/playback/report/svg_marks.h"
#include "tests/playback/xml_check.h"

namespace gaitwright {
namespace {

/// Number of drawn supports for phases of one second, each with a sample in its middle.
int SupportsDrawn(const std::vector<FootSet>& stances) {
  ContactSchedule schedule;
  std::vector<MotionSample> samples;
  for (const FootSet stance : stances) {
    const double start_s = static_cast<double>(schedule.phases.size());
    schedule.phases.push_back({start_s, start_s + 1.0, stance});
    for (const double share : {0.4, 0.6}) {
      MotionSample sample;
      sample.time_s = start_s + share;
      sample.stance = stance;
      sample.support.points_W = {Vector3::Zero()};
      sample.support.polygon = {{start_s, 0.0}, {start_s + 0.5, 0.0}, {start_s, 0.5}};
      samples.push_back(sample);
    }
  }
  SvgPlot plot = synthetic::BarePlot();
  DrawSupports(schedule, samples, plot);
  return svg_marks::Count(plot.Svg(), "class=\"support filled\"");
}

// Stances 1 and 2 are single feet: stance 3 between them only joins the two.
TEST(TopView, AStanceThatOnlyJoinsTwoOthersHasNoSupport) {
  EXPECT_EQ(SupportsDrawn({3, 1, 3, 2, 3}), 4) << "both ends and both single stances";
  EXPECT_EQ(SupportsDrawn({3}), 1);
  EXPECT_EQ(SupportsDrawn({1, 2, 1}), 3) << "a run has no double support";
  EXPECT_EQ(SupportsDrawn({15, 14, 15, 13, 15, 11, 15}), 5);
}

TEST(TopView, FootholdsAreDrawnUpToTheEnd) {
  synthetic::Drawn c(synthetic::Walked(2, {.count = 4}));
  const auto drawn = [&] { return svg_marks::Count(TopView(c.Data()).svg, "class=\"foot filled\""); };
  const int all = drawn();
  ASSERT_GT(all, 4);
  for (Foothold& foothold : c.plan.footsteps.footholds) {
    if (&foothold == &c.plan.footsteps.footholds.back()) foothold.touchdown_s += 1e3;
  }
  EXPECT_EQ(drawn(), all - 1);
}

// Feet without soles are dots at their footholds and crosses at their measured landings.
TEST(TopView, PointsAreDotsAndCrosses) {
  const synthetic::Drawn soles(synthetic::Walked(2, {.count = 2})), balls(synthetic::Walked(4, {.count = 2}));
  const std::string of_soles = TopView(soles.Data()).svg, of_balls = TopView(balls.Data()).svg;
  EXPECT_EQ(svg_marks::Dots(of_soles, "foot").size(), 0U);
  EXPECT_GT(svg_marks::Count(of_soles, "class=\"foot outline\""), 0);
  EXPECT_GE(svg_marks::Dots(of_balls, "foot").size(), balls.plan.footsteps.footholds.size());
  EXPECT_EQ(svg_marks::Count(of_balls, "class=\"foot outline\""), 0);
  EXPECT_GT(svg_marks::Count(of_balls, "class=\"foot heavy\""), 0);
  for (const std::string& svg : {of_soles, of_balls}) EXPECT_EQ(XmlFault(svg), "");
}

TEST(TopView, PathsOfAPlanAloneAreThePlans) {
  const synthetic::Drawn c(synthetic::Walked(2, {.count = 2}));
  MotionSeries series = c.Data().series;
  series.measured.clear();
  SvgPlot plot = synthetic::BarePlot();
  DrawPaths(series, plot);
  EXPECT_EQ(svg_marks::Paths(plot.Svg(), "com planned").size(), 1U);
  EXPECT_EQ(svg_marks::Paths(plot.Svg(), "zmp planned").size(), 1U);
  EXPECT_EQ(svg_marks::Count(plot.Svg(), " measured\""), 0);
}

// One metre has the same length on x and y, so the arrow of the goal only turns with its heading.
TEST(TopView, TheGoalsArrowTurnsWithItsHeading) {
  synthetic::Drawn c(synthetic::Stood());
  const auto arrow = [&](double yaw_rad) {
    c.plan.goal.yaw_rad = yaw_rad;
    const auto path = svg_marks::Paths(TopView(c.Data()).svg, "bad filled").at(0);
    return Vector2(path.at(0) - path.at(2));  // from the notch to the tip
  };
  const Vector2 forward = arrow(0.0), left = arrow(0.5 * M_PI);
  EXPECT_GT(forward.x(), 1.0);
  EXPECT_NEAR(forward.y(), 0.0, 0.15);
  EXPECT_NEAR(left.x(), 0.0, 0.15);
  EXPECT_LT(left.y(), -1.0);
}

}  // namespace
}  // namespace gaitwright
