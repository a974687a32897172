// SPDX-License-Identifier: BSD-3-Clause
#include "tests/cli/exchanged.h"

namespace gaitwright::cli {
namespace {

TEST_F(Exchange, ComparesPlansLogsAndAForeignTable) {
  const Ran same = Run({"compare", "out/plan.json", "out/plan.json", "--require-same", "--tolerance", "0"});
  EXPECT_EQ(same.status, 0) << same.err << same.out;
  EXPECT_NE(same.out.find("equal: all differences are within tolerance"), std::string::npos);
  const Ran slower = Run({"compare", "out/plan.json", "slow.json", "--require-same", "--json"});
  EXPECT_EQ(slower.status, 3);
  EXPECT_EQ(slower.json().at("same"), false);
  EXPECT_FALSE(slower.json().at("first_difference").at("quantity").get<std::string>().empty());
  EXPECT_EQ(Run({"compare", "out/plan.json", "slow.json", "--quiet"}).out, "different\n");

  const Ran played = Run({"compare", "out/plan.json", "out/log.json", "--json", "--report", "compare.html"});
  ASSERT_EQ(played.status, 0) << played.err;
  EXPECT_EQ(played.json().at("alignment").at("by"), "none");
  EXPECT_TRUE(played.json().at("metrics").at("distance_m").at("a").is_number());
  EXPECT_NE(Read("compare.html").find("joint_positions"), std::string::npos);

  ASSERT_EQ(Run({"export", "out/plan.json", "--rate-hz", "500", "--out", "motion.csv", "--quiet"}).status, 0);
  const Ran table = Run({"compare", "out/plan.json", "motion.csv", "--json", "--require-same", "--tolerance", "0.01"});
  EXPECT_EQ(table.status, 0) << table.out.substr(0, 600) << table.err;
  EXPECT_EQ(table.json().at("alignment").at("offset_s"), 0.0);
  EXPECT_EQ(Run({"compare", "motion.csv", "motion.csv", "--robot", "a1", "--quiet"}).out, "same\n");
}

TEST_F(Exchange, ComparesReports) {
  Write("one.json", Run({"play", "out/plan.json", "--json"}).out);
  Write("two.json", Run({"play", "out/plan.json", "--json", "--mass-scale", "1.1"}).out);
  EXPECT_EQ(Run({"compare", "one.json", "one.json", "--quiet"}).out, "same\n");
  const Ran ran = Run({"compare", "one.json", "two.json", "--json", "--report", "two.html"});
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_EQ(ran.json().at("compared"), "reports");
  EXPECT_EQ(ran.json().at("metrics").at("fell").at("a"), 0.0);
  EXPECT_NE(Run({"compare", "one.json", "two.json", "--tolerance", "0"}).out.find("different; "), std::string::npos);
}

TEST_F(Exchange, CompareRefusesWhatDoesNotBelongTogether) {
  Write("report.json", Run({"play", "out/plan.json", "--json"}).out);
  Write("empty.json", "{}");
  Write("trials.json", R"({"n": 2, "survived": 2, "survival": 1.0})");
  Write("part.csv", "time_s,battery\n0,1\n");
  ExpectRefused(Run({"compare", "report.json", "out/plan.json"}), 1, {"report.json", "a plan", "with a report"});
  ExpectRefused(Run({"compare", "empty.json", "out/plan.json"}), 1, {"empty.json", "not a plan, log or report"});
  ExpectRefused(Run({"compare", "trials.json", "out/plan.json"}), 1,
                {"'trials.json' is a result of trials, which 'compare' does not accept", "trials --report FILE"});
  ExpectRefused(Run({"compare", "out/log.json", "out/log.json"}), 1, {"a log of robot 'a1'", "--plan FILE"});
  ExpectRefused(Run({"compare", "part.csv", "part.csv"}), 1, {"does not name the robot", "--robot NAME"});
  ExpectRefused(Run({"compare", "out/plan.json", "part.csv"}), 1, {"part.csv", "_joint"});
  ExpectRefused(Run({"compare", "out/plan.json", "slow.json", "--columns", "names.yaml"}), 1,
                {"neither file is a CSV"});
  ExpectRefused(Run({"compare", "out/plan.json", "slow.json", "--align", "backward"}), 1, {"backward", "best"});
  ExpectRefused(Run({"compare", "out/plan.json", "slow.json", "--report", "slow.json"}), 1, {"would overwrite"});
}

}  // namespace
}  // namespace gaitwright::cli
