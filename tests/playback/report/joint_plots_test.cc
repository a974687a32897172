// SPDX-License-Identifier: BSD-3-Clause
// Plots of joints: which joints are shown, and bars of torques as shares of their limits.
#include <gtest/gtest.h>

#include <limits>

#include "tests/playback/report/made_plots.h"
#include "tests/playback/report/svg_marks.h"
#include "tests/playback/xml_check.h"

namespace gaitwright {
namespace {

TEST(JointPlots, HaveAPlotForEachJointOfALeg) {
  const synthetic::Drawn c(synthetic::Walked(2, {.count = 2}));
  const std::vector<Plot> plots = JointPlots(c.Data());
  ASSERT_EQ(plots.size(), 3U);
  for (const char* name : {"joint_torques", "joint_positions"}) {
    const std::string& svg = synthetic::PlotNamed(plots, name).svg;
    EXPECT_EQ(XmlFault(svg), "") << name;
    EXPECT_EQ(svg_marks::Count(svg, "class=\"frame\""), c.model.num_dofs()) << name;
  }
}

// A joint that belongs to no leg is shown if the plan moves it by more than 0.001.
TEST(JointPlots, LeaveOutJointsOfNoLegThatDoNotMove) {
  synthetic::Drawn still(synthetic::Stood());
  PlotData data = still.Data();  // its series need legs with joints
  const auto shown = [&] {
    return svg_marks::Count(synthetic::PlotNamed(JointPlots(data), "joint_positions").svg, "class=\"frame\"");
  };
  const int joints = still.model.num_dofs();
  EXPECT_EQ(shown(), joints);
  const auto of_leg = static_cast<int>(still.model.legs[0].joints.size());
  const int dof = still.model.joints[static_cast<std::size_t>(still.model.legs[0].joints[0])].dof;
  still.model.legs[0].joints.clear();
  EXPECT_EQ(shown(), joints - of_leg);
  data.series.plan[1].q[7 + dof] += 0.01;
  EXPECT_EQ(shown(), joints - of_leg + 1);
  data.series.plan[1].q[7 + dof] -= 0.01;
  still.model.legs[1].joints.clear();
  EXPECT_TRUE(JointPlots(data).empty());
}

// The axis goes from 0 to 105 % if no plan exceeds its limit.
TEST(JointPlots, BarsAreSharesOfTheLimit) {
  synthetic::Drawn c(synthetic::Stood());
  for (Joint& joint : c.model.joints) joint.effort_limit = 1000.0;
  for (LogSample& sample : c.log.samples) sample.tau_peak.setConstant(10.0);
  c.log.samples[3].tau_peak.setConstant(420.0);
  const std::string svg = synthetic::PlotNamed(JointPlots(c.Data()), "torque_use").svg;
  const svg_marks::Box axes = svg_marks::Boxes(svg, "frame").at(0);
  const auto bars = svg_marks::Boxes(svg, "joint bar-measured");
  ASSERT_GE(static_cast<int>(bars.size()), c.model.num_dofs());
  for (int dof = 0; dof < c.model.num_dofs(); ++dof) {
    const svg_marks::Box& bar = bars[static_cast<std::size_t>(dof)];
    EXPECT_NEAR(bar.left, axes.left, 0.2);
    EXPECT_NEAR(bar.right, axes.left + (axes.right - axes.left) * 42.0 / 105.0, 0.3) << "the largest, 420 of 1000";
  }
}

TEST(JointPlots, WithoutTorqueLimitsHaveNoSharesOfThem) {
  synthetic::Drawn c(synthetic::Stood());
  for (Joint& joint : c.model.joints) joint.effort_limit = std::numeric_limits<double>::infinity();
  const std::vector<Plot> plots = JointPlots(c.Data());
  ASSERT_EQ(plots.size(), 2U);
  EXPECT_EQ(plots[0].name, "joint_torques");
  EXPECT_EQ(plots[0].svg.find("limit"), std::string::npos);
}

TEST(JointPlots, SlidesHaveForcesAndHingesTorques) {
  synthetic::Drawn c(synthetic::Stood());
  const std::string slides = synthetic::PlotNamed(JointPlots(c.Data()), "joint_torques").svg;
  EXPECT_NE(slides.find(">force [N]<"), std::string::npos);
  EXPECT_EQ(slides.find(">torque [N m]<"), std::string::npos);
  PlotData data = c.Data();
  RobotModel hinged = c.model;
  for (Joint& joint : hinged.joints) joint.type = JointType::kRevolute;
  const PlotData of_hinges{hinged, c.plan, c.log, c.report, data.series};
  const std::string hinges = synthetic::PlotNamed(JointPlots(of_hinges), "joint_torques").svg;
  EXPECT_NE(hinges.find(">torque [N m]<"), std::string::npos);
  EXPECT_EQ(hinges.find(">force [N]<"), std::string::npos);
}

}  // namespace
}  // namespace gaitwright
