// SPDX-License-Identifier: BSD-3-Clause
// Plots of balance over time: gaps, steps of the support, and angles without jumps.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/playback/report/made_plots.h"
#include "tests/playback/report/svg_marks.h"
#include "tests/playback/xml_check.h"

namespace gaitwright {
namespace {

/// `count` samples, 0.1 s apart, on a square support of 0.2 m, with the ZMP in its middle.
std::vector<MotionSample> BalancedSamples(int count) {
  std::vector<MotionSample> samples(static_cast<std::size_t>(count));
  for (std::size_t k = 0; k < samples.size(); ++k) {
    samples[k].time_s = 0.1 * static_cast<double>(k);
    samples[k].has_zmp = true;
    samples[k].stance = 1;
    samples[k].support.polygon = {{-0.1, -0.1}, {0.1, -0.1}, {0.1, 0.1}, {-0.1, 0.1}};
    samples[k].support.points_W = {Vector3::Zero()};
  }
  return samples;
}

TEST(BalancePlots, AreSixWellFormedPlots) {
  const synthetic::Drawn c(synthetic::Walked(2, {.count = 2}));
  std::vector<std::string> names;
  for (const Plot& plot : BalancePlots(c.Data())) {
    names.push_back(plot.name);
    EXPECT_EQ(XmlFault(plot.svg), "") << plot.name;
  }
  EXPECT_EQ(names,
            (std::vector<std::string>{"zmp_com_x", "zmp_com_y", "margins", "errors", "base_attitude", "base_height"}));
}

TEST(BalancePlots, AZmpThatIsMissingLeavesAGap) {
  MotionSeries series;
  series.planned = BalancedSamples(9);
  for (MotionSample& sample : series.planned) sample.p_WC.x() = std::sin(7.0 * sample.time_s);
  const auto path = [&] {
    SvgPlot plot = synthetic::BarePlot();
    DrawBalance(series, 0, plot);
    return plot.Svg();
  };
  const auto pieces = [](const std::string& svg) {
    const std::size_t end = svg.find("\" class=\"zmp planned\"");
    const std::size_t begin = svg.rfind("d=\"", end);
    return svg_marks::Count(svg.substr(begin, end - begin), "M");
  };
  EXPECT_EQ(pieces(path()), 1);
  series.planned[4].has_zmp = false;
  EXPECT_EQ(pieces(path()), 2);
}

TEST(BalancePlots, WithoutAMeasurementOnlyThePlanIsDrawn) {
  MotionSeries series;
  series.planned = BalancedSamples(5);
  SvgPlot plot = synthetic::BarePlot();
  DrawBalance(series, 1, plot);
  EXPECT_EQ(svg_marks::Count(plot.Svg(), " planned\""), 2);
  EXPECT_EQ(svg_marks::Count(plot.Svg(), " measured\""), 0);
  series.measured = series.planned;
  SvgPlot both = synthetic::BarePlot();
  DrawBalance(series, 1, both);
  EXPECT_EQ(svg_marks::Count(both.Svg(), " measured\""), 2);
}

// The support jumps forward by 0.3 m when the stance changes: its band has vertical sides there.
TEST(BalancePlots, TheSupportChangesInAStep) {
  MotionSeries series;
  series.planned = BalancedSamples(4);
  for (std::size_t k = 2; k < 4; ++k) {
    series.planned[k].stance = 2;
    for (Vector2& corner : series.planned[k].support.polygon) corner.x() += 0.3;
  }
  SvgPlot plot = synthetic::BarePlot();
  DrawBalance(series, 0, plot);
  const auto band = svg_marks::Paths(plot.Svg(), "support band").at(0);
  int upright = 0;
  for (std::size_t i = 1; i < band.size(); ++i) {
    const Vector2 side = band[i] - band[i - 1];
    if (std::abs(side.y()) < 1.0) continue;
    EXPECT_LT(std::abs(side.x()), 0.2) << "no slope";
    ++upright;
  }
  EXPECT_EQ(upright, 3) << "lower and upper side of the step, and the end";
}

// The base turns twice to the left: its yaw continues beyond half a turn.
TEST(BalancePlots, TheYawHasNoJumps) {
  const synthetic::Drawn c(synthetic::Stood());
  PlotData data = c.Data();
  const std::size_t rows = data.series.measured.size();
  for (std::size_t k = 0; k < rows; ++k) {
    const double yaw = 4.0 * M_PI * static_cast<double>(k) / static_cast<double>(rows - 1);
    data.series.measured[k].X_WB.linear() = Eigen::AngleAxisd(yaw, Vector3::UnitZ()).toRotationMatrix();
  }
  const auto plots = BalancePlots(data);
  const auto yaw = svg_marks::Paths(synthetic::PlotNamed(plots, "base_attitude").svg, "foot measured").at(0);
  ASSERT_GE(yaw.size(), 2U);
  for (std::size_t i = 1; i < yaw.size(); ++i) EXPECT_LE(yaw[i].y(), yaw[i - 1].y()) << "always to the left";
  EXPECT_LT(yaw.back().y(), yaw.front().y() - 100.0);
}

}  // namespace
}  // namespace gaitwright
