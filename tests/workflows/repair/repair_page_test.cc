// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tests/workflows/repair/bad_repair.h"
#include "workflows/repair/repair_page_internal.h"

namespace gaitwright {
namespace {

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

TEST(RepairPage, TablesHaveWhatFailsAndHowFarItIs) {
  const RobotModel& model = NamedRobot("a1");
  const MotionFindings findings = synthetic::BadFindings();
  const RepairedMotion repaired = synthetic::BadRepair();
  const std::string page = RepairPage({model, findings, &repaired}, {"clips/dance.csv"});
  EXPECT_TRUE(Has(page, "a1: repair of dance.csv"));
  EXPECT_TRUE(Has(page, "<span class=\"verdict fail\">FAIL</span>"));
  EXPECT_TRUE(Has(page, "<div class=\"figure\">-12.0 mm</div><div class=\"limit\">they sink into the ground</div>"));
  const auto laws = RowsOf(page, "laws");
  ASSERT_EQ(laws.size(), 2U);
  EXPECT_TRUE(Has(laws[0], ">reach<") && Has(laws[0], "25.0 %") && Has(laws[0], "1 to 2&#160;s") &&
              Has(laws[0], "0.5 m"));
  EXPECT_TRUE(Has(laws[0], "\u2013")) << "does not fail any more";
  EXPECT_TRUE(Has(laws[1], "50.0 %") && Has(laws[1], "10.0 %") && Has(laws[1], "90 N m") && Has(laws[1], "40 N m"));
  const auto groups = RowsOf(page, "groups");
  ASSERT_EQ(groups.size(), 2U);
  EXPECT_TRUE(Has(groups[0], "0.0625 rad") && Has(groups[0], "0.2500 rad") && Has(groups[0], "FL_calf_joint"));
  EXPECT_TRUE(Has(groups[1], "15.5 mm") && Has(groups[1], "31.0 mm"));
  const auto unsaved = UnsavedParts({model, findings, &repaired}, "");
  ASSERT_EQ(unsaved.size(), 1U);
  EXPECT_TRUE(Has(unsaved[0], "joint_torque") && Has(unsaved[0], "10.0 %") && Has(unsaved[0], "4.50 s")) << unsaved[0];
  MotionFindings shorter = findings;
  shorter.left_out = {{0.5, 1.75, Pose::Identity(), "it flies"}};
  EXPECT_EQ(UnsavedParts({model, shorter, &repaired}, "").size(), 2U);
  shorter.lost = {{0.0, 3.5, Pose::Identity(), "it flies"}};
  EXPECT_EQ(UnsavedParts({model, shorter, &repaired}, "").size(), 3U);
  RepairedMotion sound = repaired;
  sound.after.violations.clear();
  sound.broken.clear();
  EXPECT_TRUE(Has(RepairPage({model, shorter, &sound}, {"dance.csv"}), "without 1.25 s of the original"));
}

TEST(RepairPage, OfACheckOrARefusalIsTheFirstHalf) {
  const RobotModel& model = NamedRobot("a1");
  const MotionFindings findings = synthetic::BadFindings();
  const std::string check = RepairPage({model, findings}, {"dance.csv"});
  EXPECT_EQ(RowsOf(check, "laws").size(), 2U);
  EXPECT_FALSE(Has(check, "<table id=\"groups\""));
  EXPECT_FALSE(Has(check, "that stay infeasible"));
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
