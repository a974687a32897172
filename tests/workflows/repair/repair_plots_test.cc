// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/playback/report/svg_marks.h"
#include "tests/workflows/repair/bad_repair.h"
#include "workflows/repair/repair_page_internal.h"

namespace gaitwright {
namespace {

TEST(RepairPlots, BarsAreTheTimesOfFailingChecks) {
  const MotionFindings findings = synthetic::BadFindings();
  const RepairedMotion repaired = synthetic::BadRepair();
  const Plot plot = BrokenPlot({NamedRobot("a1"), findings, &repaired});
  const auto bars = svg_marks::Boxes(plot.svg, "bad bar-measured");
  ASSERT_EQ(bars.size(), 4U) << "two milliseconds apart is one bar";
  const double second = bars[0].right - bars[0].left;  // of the axis [px]
  const double zero = bars[0].left - second;
  EXPECT_NEAR(bars[1].left, zero + 2.0 * second, 0.3);
  EXPECT_NEAR(bars[1].right, zero + 3.0 * second, 0.3);
  EXPECT_GT(bars[1].top, bars[0].bottom) << "in the next row";
  EXPECT_NEAR(bars[2].left, zero + 3.25 * second, 0.3);
  EXPECT_NEAR(bars[3].left, zero + 4.4 * second, 0.3) << "the same axis for the repaired motion";
  EXPECT_NEAR(bars[3].right, zero + 4.9 * second, 0.3);
  EXPECT_EQ(svg_marks::Count(plot.svg, ">joint_torque<"), 2);
  EXPECT_EQ(svg_marks::Count(BrokenPlot({NamedRobot("a1"), findings}).svg, ">joint_torque<"), 1);
  EXPECT_EQ(BrokenPlot({NamedRobot("a1"), MotionFindings{}}).svg, "");
}

TEST(RepairPlots, CurvesOfLongMotionsKeepTheirPeaks) {
  MotionDistance distance;
  std::vector<float> peak(60001, 0.0F);
  peak[30017] = 0.5F;
  distance.groups = {{"legs", "rad", 0.1, 0.5, 300.17, "knee", peak}, {"feet", "m", 0.0, 0.0, 0.0, "", peak}};
  const Plot plot = DistancePlot(distance, 0.01);
  std::vector<std::vector<Vector2>> paths = svg_marks::Paths(plot.svg, "foot measured");
  std::erase_if(paths, [](const auto& path) { return path.size() < 3; });  // of the legend
  ASSERT_EQ(paths.size(), 2U);
  for (const auto& path : paths) {
    const auto top =
        std::min_element(path.begin(), path.end(), [](const Vector2& a, const Vector2& b) { return a.y() < b.y(); });
    EXPECT_GT(path.front().y() - top->y(), 100.0);
    EXPECT_NEAR(top->x(), 0.5 * (path.front().x() + path.back().x()), 2.0);
  }
}

}  // namespace
}  // namespace gaitwright
