// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "tests/playback/report/svg_marks.h"
#include "tests/workflows/repair/standing_motion.h"
#include "workflows/repair/repair_page_internal.h"

namespace gaitwright {
namespace {

/// Findings on a motion of 4 s that fails two checks.
MotionFindings BadFindings() {
  MotionFindings findings;
  findings.format = "frames-csv";
  findings.rows = 400;
  findings.duration_s = 4.0;
  findings.rested.motion.step_s = 0.01;
  findings.rested.file_s.assign(401, 0.0);
  findings.before = AuditReport{};
  findings.before->violations = {{Law::kReach, 1.25, "FL_foot", 0.5, 0.4, "m"},
                                 {Law::kJointTorque, 3.5, "FL_calf_joint", 90.0, 33.5, "N m"}};
  findings.broken = {{Law::kReach, 0.25, {1.0}, {{1.0, 2.0}}},
                     {Law::kJointTorque, 0.5, {2.0, 3.0}, {{2.0, 2.5}, {2.502, 3.0}, {3.25, 4.0}}}};
  return findings;
}

/// A repair of it that takes a second longer and still fails one check.
RepairedMotion Repaired() {
  RepairedMotion repaired;
  const EvenMotion original = synthetic::Standing(NamedRobot("a1"), 501);
  repaired.plan.robot = "a1";
  repaired.plan.whole_body.step_s = original.step_s;
  repaired.plan.whole_body.q = original.q;
  repaired.original = std::make_shared<const EvenMotion>(original);
  repaired.after.violations = {{Law::kJointTorque, 4.5, "FL_calf_joint", 40.0, 33.5, "N m"}};
  repaired.broken = {{Law::kJointTorque, 0.1, {4.0}, {{4.4, 4.9}}}};
  repaired.distance.groups = {{"legs", "rad", 0.0625, 0.25, 2.0, "FL_calf_joint", std::vector<float>(501, 0.0625F)},
                              {"base", "m", 0.0155, 0.031, 1.0, "", std::vector<float>(501, 0.0155F)}};
  return repaired;
}

/// The rows of a table by its id.
std::vector<std::string> RowsOf(const std::string& page, const std::string& id) {
  const std::size_t from = page.find("<tbody>", page.find("<table id=\"" + id + "\"")),
                    to = page.find("</tbody>", from);
  std::vector<std::string> rows;
  for (std::size_t at = page.find("<tr>", from); at < to; at = page.find("<tr>", at + 1))
    rows.push_back(page.substr(at, page.find("</tr>", at) - at));
  return rows;
}

bool Has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(RepairPage, BarsAreTheTimesOfFailingChecks) {
  const MotionFindings findings = BadFindings();
  const RepairedMotion repaired = Repaired();
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

TEST(RepairPage, CurvesOfLongMotionsKeepTheirPeaks) {
  MotionDistance distance;
  std::vector<float> peak(60001, 0.0F);
  peak[30017] = 0.5F;
  distance.groups = {{"legs", "rad", 0.1, 0.5, 300.17, "knee", peak}, {"feet", "m", 0.0, 0.0, 0.0, "", peak}};
  const Plot plot = DistancePlot(distance, 0.01);
  const auto paths = svg_marks::Paths(plot.svg, "foot measured");
  ASSERT_EQ(paths.size(), 2U);
  for (const auto& path : paths) {
    const auto top =
        std::min_element(path.begin(), path.end(), [](const Vector2& a, const Vector2& b) { return a.y() < b.y(); });
    EXPECT_GT(path.front().y() - top->y(), 100.0);
    EXPECT_NEAR(top->x(), 0.5 * (path.front().x() + path.back().x()), 2.0);
  }
}

TEST(RepairPage, TablesHaveWhatFailsAndHowFarItIs) {
  const RobotModel& model = NamedRobot("a1");
  const MotionFindings findings = BadFindings();
  const RepairedMotion repaired = Repaired();
  const std::string page = RepairPage({model, findings, &repaired}, {"clips/dance.csv"});
  EXPECT_TRUE(Has(page, "a1: repair of dance.csv"));
  EXPECT_TRUE(Has(page, "<span class=\"verdict fail\">FAIL</span>"));
  const auto laws = RowsOf(page, "laws");
  ASSERT_EQ(laws.size(), 2U);
  EXPECT_TRUE(Has(laws[0], ">reach<") && Has(laws[0], "25.0 %") && Has(laws[0], "1 to 2&#160;s") && Has(laws[0], "0.5 m"));
  EXPECT_TRUE(Has(laws[0], "\u2013")) << "does not fail any more";
  EXPECT_TRUE(Has(laws[1], "50.0 %") && Has(laws[1], "10.0 %") && Has(laws[1], "90 N m") && Has(laws[1], "40 N m"));
  const auto groups = RowsOf(page, "groups");
  ASSERT_EQ(groups.size(), 2U);
  EXPECT_TRUE(Has(groups[0], "0.0625 rad") && Has(groups[0], "0.2500 rad") && Has(groups[0], "FL_calf_joint"));
  EXPECT_TRUE(Has(groups[1], "15.5 mm") && Has(groups[1], "31.0 mm"));
  const auto unsaved = UnsavedParts({model, findings, &repaired}, "");
  ASSERT_EQ(unsaved.size(), 1U);
  EXPECT_TRUE(Has(unsaved[0], "joint_torque") && Has(unsaved[0], "10.0 %") && Has(unsaved[0], "4.50 s")) << unsaved[0];
}

TEST(RepairPage, OfACheckOrARefusalIsTheFirstHalf) {
  const RobotModel& model = NamedRobot("a1");
  const MotionFindings findings = BadFindings();
  const std::string check = RepairPage({model, findings}, {"dance.csv"});
  EXPECT_EQ(RowsOf(check, "laws").size(), 2U);
  EXPECT_FALSE(Has(check, "<table id=\"groups\""));
  EXPECT_FALSE(Has(check, "could not be saved"));
  const std::string refused = RepairPage({model, findings}, {"dance.csv", "no motion <near> it at 2.5 s"});
  EXPECT_TRUE(Has(refused, ">REFUSED</span>"));
  EXPECT_EQ(RowsOf(refused, "laws").size(), 2U);
  EXPECT_TRUE(Has(refused, "<li>no motion &lt;near&gt; it at 2.5 s</li>"));
  MotionFindings unknown;
  unknown.not_audited = "it has no feet";
  EXPECT_TRUE(Has(RepairPage({model, unknown}, {"dance.csv"}), "it has no feet"));
}

}  // namespace
}  // namespace gaitwright
