// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/exchange/motion_plots.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/playback/xml_check.h"
#include "tests/workflows/exchange/quoted_walker.h"

namespace gaitwright {
namespace {

std::vector<std::string> NamesOfPlots(const std::vector<Plot>& plots) {
  std::vector<std::string> names;
  for (const Plot& plot : plots) names.push_back(plot.name);
  return names;
}

const Plot& PlotNamed(const std::vector<Plot>& plots, const std::string& name) {
  for (const Plot& plot : plots) {
    if (plot.name == name) return plot;
  }
  throw InvalidArgument("no plot " + name);
}

TEST(MotionPlots, AreOfWhatTheRowsHave) {
  const synthetic::Played walker = synthetic::Walked(2, {.count = 2});
  MotionRows rows = RowsOfPlan(walker.model, walker.plan, 100.0);
  EXPECT_EQ(NamesOfPlots(MotionPlots({{"a", &walker.model, &rows}})),
            (std::vector<std::string>{"top_view", "base_position", "base_attitude", "contacts", "joint_positions",
                                      "joint_speeds", "joint_torques"}));
  rows.tau.clear();
  rows.contact.clear();
  const std::vector<std::string> fewer = NamesOfPlots(MotionPlots({{"a", &walker.model, &rows}}));
  EXPECT_EQ(std::count(fewer.begin(), fewer.end(), "joint_torques"), 0);
  EXPECT_EQ(std::count(fewer.begin(), fewer.end(), "contacts"), 0);
  EXPECT_EQ(std::count(fewer.begin(), fewer.end(), "joint_speeds"), 1);
}

TEST(MotionPlots, AreWellFormedWhateverNamesAre) {
  QuotedWalker walker;
  walker.model.joints[0].name = walker.model.dof_names[0] = "a<b>&c";
  const MotionRows rows = RowsOfPlan(walker.model, walker.plan, 100.0);
  for (const Plot& plot : MotionPlots({{"<one>", &walker.model, &rows}, {"&two", &walker.model, &rows}}, 0.5, "<here>"))
    EXPECT_EQ(XmlFault(plot.svg), "") << plot.name;
}

TEST(MotionPlots, AJointThatStaysStillInBothIsLeftOut) {
  const synthetic::Played walker = synthetic::Walked(2, {.count = 2});
  MotionRows still = RowsOfPlan(walker.model, walker.plan, 100.0);
  for (VectorX& q : still.q) q[7] = 0.25;  // left_x
  const MotionRows moves = RowsOfPlan(walker.model, walker.plan, 100.0);
  const auto shows = [&](const std::vector<DrawnMotion>& motions) {
    return synthetic::Says(PlotNamed(MotionPlots(motions), "joint_positions").svg, "left_x");
  };
  EXPECT_FALSE(shows({{"a", &walker.model, &still}, {"b", &walker.model, &still}}));
  EXPECT_TRUE(shows({{"a", &walker.model, &still}, {"b", &walker.model, &moves}}));
}

TEST(MotionPlots, AnOffsetMovesTheSecondOntoTheFirst) {
  const synthetic::Played walker = synthetic::Walked(2, {.count = 2});
  const MotionRows rows = RowsOfPlan(walker.model, walker.plan, 100.0);
  MotionRows late = rows;
  for (double& time_s : late.time_s) time_s += 40.0;
  const auto plots_of = [&](const MotionRows& second, double offset_s) {
    return PlotNamed(MotionPlots({{"a", &walker.model, &rows}, {"b", &walker.model, &second, offset_s}}),
                     "base_position")
        .svg;
  };
  EXPECT_EQ(plots_of(late, 40.0).size(), plots_of(rows, 0.0).size());
  EXPECT_NE(plots_of(late, 40.0), plots_of(late, 39.0));
}

TEST(MotionPlots, AMarkIsWrittenBesideItsLine) {
  const synthetic::Played walker = synthetic::Walked(2, {.count = 2});
  const MotionRows rows = RowsOfPlan(walker.model, walker.plan, 100.0);
  EXPECT_TRUE(
      synthetic::Says(PlotNamed(MotionPlots({{"a", &walker.model, &rows}}, 1.0, "first"), "contacts").svg, "first"));
}

TEST(MotionPlots, OneOrTwoMotionsWithRowsAreNeeded) {
  const synthetic::Played walker = synthetic::Stood();
  const MotionRows rows = RowsOfPlan(walker.model, walker.plan, 100.0), none;
  const DrawnMotion one{"a", &walker.model, &rows}, empty{"b", &walker.model, &none};
  EXPECT_THROW(MotionPlots({}), InvalidArgument);
  EXPECT_THROW(MotionPlots({one, one, one}), InvalidArgument);
  EXPECT_THROW(MotionPlots({one, empty}), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
