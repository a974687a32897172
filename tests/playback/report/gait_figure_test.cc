// SPDX-License-Identifier: BSD-3-Clause
#include "playback/report/gait_figure.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "kinematics/base/result.h"
#include "tests/playback/played.h"
#include "tests/playback/xml_check.h"

namespace gaitwright {
namespace {

std::size_t Count(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST(GaitFigure, HasThePlanAloneOrWithWhatWasMeasured) {
  const synthetic::Played c = synthetic::Walked(2, {.count = 6});
  const std::string planned = GaitFigure(c.model, c.plan, nullptr), both = GaitFigure(c.model, c.plan, &c.log);
  for (const std::string& svg : {planned, both}) {
    EXPECT_EQ(XmlFault(svg), "");
    EXPECT_TRUE(synthetic::Says(svg, "support polygons"));
    EXPECT_TRUE(synthetic::Says(svg, "ZMP planned"));
    EXPECT_FALSE(synthetic::Says(svg, "nan"));
  }
  EXPECT_FALSE(synthetic::Says(planned, "ZMP measured"));
  EXPECT_TRUE(synthetic::Says(both, "ZMP measured"));
}

/// A cycle of the synthetic biped has two steps; each has its own support polygon.
TEST(GaitFigure, ShowsSoManyCyclesFromTheFirstStep) {
  synthetic::Played c = synthetic::Walked(2, {.count = 12});
  c.plan.swings.push_back({.foot = 0, .start_s = 0.9, .end_s = 1.3});
  const auto polygons = [&](int cycles) {
    return Count(GaitFigure(c.model, c.plan, nullptr, {.cycles = cycles}), "class=\"support filled\"");
  };
  const std::size_t two = polygons(2), four = polygons(4);
  EXPECT_GE(two, 3U);
  EXPECT_NEAR(static_cast<double>(four), 2.0 * static_cast<double>(two), 2.0);
}

TEST(GaitFigure, TellsHowManyCyclesTheMotionHas) {
  synthetic::Played c = synthetic::Walked(2, {.count = 12});
  c.plan.swings.push_back({.foot = 0, .start_s = 0.9, .end_s = 1.3});
  const double cycle_s = PartAt(c.plan.parts, 1.0)->gait.cycle_s, end_s = c.plan.whole_body.end_s();
  EXPECT_DOUBLE_EQ(CyclesShown(c.plan, &c.log, {.cycles = 2}), 2.0);
  EXPECT_NEAR(CyclesShown(c.plan, nullptr, {.cycles = 1000}), (end_s - 0.9) / cycle_s, 1e-9);
  c.log.samples.resize(c.log.samples.size() / 2);
  EXPECT_NEAR(CyclesShown(c.plan, &c.log, {.cycles = 1000}), (c.log.samples.back().time_s - 0.9) / cycle_s, 1e-9);
}

TEST(GaitFigure, RefusesWindowsWithoutMotion) {
  const synthetic::Played c = synthetic::Stood();
  EXPECT_THROW(GaitFigure(c.model, c.plan, nullptr, {.cycles = 0}), InvalidArgument);
  EXPECT_THROW(GaitFigure(c.model, c.plan, nullptr, {.cycles = 1, .from_s = 100.0}), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
