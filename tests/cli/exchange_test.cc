// SPDX-License-Identifier: BSD-3-Clause
// Motions go out to other programs, and are set side by side.
#include <algorithm>

#include "tests/cli/stranger.h"

namespace gaitwright::cli {
namespace {

class Exchange : public Stranger {
 protected:
  Exchange() {
    EXPECT_EQ(Run({"walk", "--speed", "0.5", "--distance", "0.3", "--engine", "bullet", "--quiet", "--out-dir", "out"})
                  .status,
              0);
    EXPECT_EQ(Run({"plan", "--distance", "0.3", "--speed", "0.2", "--out", "slow.json", "--quiet"}).status, 0);
  }

  static std::size_t LinesIn(const std::string& text) {
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  }
};

TEST_F(Exchange, ExportWritesEachFormatOfAPlanAndALog) {
  for (const char* format : {"csv", "joint-trajectory-yaml", "joint-trajectory-json", "npz"}) {
    SCOPED_TRACE(format);
    for (const char* name : {"one", "two"}) {
      const Ran ran = Run({"export", "out/plan.json", "--format", format, "--rate-hz", "250", "--out", name, "--json"});
      ASSERT_EQ(ran.status, 0) << ran.err;
      EXPECT_EQ(ran.json().at("format"), format);
      EXPECT_EQ(ran.json().at("from"), "plan");
      EXPECT_EQ(ran.json().at("files"), (Json{{"motion", name}}));
    }
    EXPECT_TRUE(Read("one") == Read("two")) << "the same bytes";
    EXPECT_GT(Read("one").size(), 10000U);
  }
  const Ran log = Run({"export", "out/log.json", "--robot", "a1", "--out", "log.csv", "--json"});
  ASSERT_EQ(log.status, 0) << log.err;
  EXPECT_EQ(log.json().at("rate_hz"), 200.0);
  EXPECT_EQ(LinesIn(Read("log.csv")), log.json().at("rows").get<std::size_t>() + 1);
  EXPECT_EQ(Run({"export", "out/log.json", "--plan", "out/plan.json", "--format", "svg", "--quiet"}).out, "plots\n");
  for (const char* plot : {"zmp_com_x.svg", "joint_torques.svg"})
    EXPECT_TRUE(std::filesystem::is_regular_file(In("plots") / plot)) << plot;
}

TEST_F(Exchange, ExportRefusesWhatItCannotDo) {
  ExpectRefused(Run({"export", "out/log.json"}), 1, {"a log of robot 'a1'", "--plan FILE", "--robot a1"});
  ExpectRefused(Run({"export", "out/log.json", "--robot", "nao"}), 1, {"the log is of robot 'a1'", "'nao'"});
  ExpectRefused(Run({"export", "out/log.json", "--plan", "slow.json"}), 1, {"the log was played from plan"});
  ExpectRefused(Run({"export", "out/log.json", "--robot", "a1", "--rate-hz", "1000"}), 1,
                {"1000 Hz", "200 Hz", "--log-rate-hz"});
  ExpectRefused(Run({"export", "out/plan.json", "--format", "cvs"}), 1, {"'cvs'", "nearest is 'csv'", "'npz'"});
  ExpectRefused(Run({"export", "out/plan.json", "--rate-hz", "1e6"}), 1, {"10000"});
  ExpectRefused(Run({"export", "out/plan.json", "--rate-hz", "-5"}), 1, {"-5", "0.1"});
  ExpectRefused(Run({"export", "out/plan.json", "--robot", "a1"}), 1, {"contains its robot"});
  ExpectRefused(Run({"export", "out/plan.json", "--out", "out/plan.json"}), 1, {"would overwrite"});
  ExpectRefused(Run({"export", "none.json"}), 1, {"none.json"});
  Write("text.txt", "nothing");
  ExpectRefused(Run({"export", "text.txt"}), 1, {"text.txt", "neither a plan nor a log"});
  EXPECT_EQ(Found(), (std::vector<std::string>{"out", "slow.json", "text.txt"})) << "nothing was written";
}

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

TEST_F(Exchange, WhatIsExportedIsImportedAsTheSameMotion) {
  ASSERT_EQ(Run({"export", "out/plan.json", "--rate-hz", "500", "--out", "motion.csv", "--quiet"}).status, 0);
  const Ran imported = Run({"import", "motion.csv", "--robot", "a1", "--out", "again.json", "--quiet"});
  ASSERT_TRUE(imported.status == 0 || imported.status == 3) << imported.err;
  const Json c = Run({"compare", "out/plan.json", "again.json", "--json"}).json();
  EXPECT_NEAR(c.at("alignment").at("best_offset_s").get<double>(), 0.0, 2e-4);
  for (const auto& [joint, difference] : c.at("joints").items()) {
    EXPECT_LT(difference.at("position").at("largest"), 1e-3) << joint;
    EXPECT_LT(difference.at("speed").at("rms"), 0.05) << joint;
  }
  EXPECT_LT(c.at("base").at("x of the base").at("largest"), 1e-4);
  EXPECT_FALSE(c.at("words").empty()) << "who made them is not the same";
}

TEST_F(Exchange, ACsvIsComparedInTheOrderAndUnitsThatAreSaid) {
  ASSERT_EQ(Run({"export", "out/plan.json", "--out", "motion.csv", "--quiet"}).status, 0);
  const std::string motion = Read("motion.csv"), head = motion.substr(0, motion.find('\n'));
  const std::string ours = "base_qx,base_qy,base_qz,base_qw";
  const std::size_t at = head.find(ours);
  ASSERT_NE(at, std::string::npos);
  // The columns that are named x, y, z, w hold w, x, y, z.
  Write("w_first.csv", std::string(motion).replace(at, ours.size(), "base_qy,base_qz,base_qw,base_qx"));
  ExpectRefused(Run({"compare", "out/plan.json", "w_first.csv"}), 1,
                {"w_first.csv", "probably has w first", "Use --quaternion-order wxyz"});
  Write("order.yaml", "quaternion_order: wxyz\n");
  for (const auto& [flag, value] : {std::pair{"--columns", "order.yaml"}, {"--quaternion-order", "wxyz"}}) {
    const Ran ran = Run({"compare", "out/plan.json", "w_first.csv", flag, value, "--json"});
    ASSERT_EQ(ran.status, 0) << ran.err;
    EXPECT_LT(ran.json().at("base").at("attitude of the base").at("largest"), 1e-3) << flag;
  }
  ExpectRefused(Run({"compare", "out/plan.json", "motion.csv", "--time-unit", "hours"}), 1, {"hours", "'ns'"});
  ExpectRefused(Run({"compare", "out/plan.json", "slow.json", "--time-unit", "ms"}), 1, {"neither file is a CSV"});
}

TEST_F(Exchange, TwoCsvsMayHaveNamesOfTheirOwn) {
  ASSERT_EQ(Run({"export", "out/plan.json", "--out", "motion.csv", "--quiet"}).status, 0);
  Write("theirs.csv", std::string(Read("motion.csv")).replace(0, 6, "clock"));
  Write("names.yaml", "columns: {clock: time_s}\nscale: {clock: 1}\n");
  for (const char* flag : {"--columns", "--columns-b"}) {
    const Ran ran = Run({"compare", "motion.csv", "theirs.csv", "--robot", "a1", flag, "names.yaml", "--quiet"});
    EXPECT_EQ(ran.out, "same\n") << flag << ": " << ran.err;
  }
  Write("wrong.yaml", "columns: {clok: time_s}\n");
  ExpectRefused(Run({"compare", "motion.csv", "theirs.csv", "--robot", "a1", "--columns", "wrong.yaml"}), 1,
                {"there is no column 'clok' to take as 'time_s'"});
  ExpectRefused(Run({"compare", "theirs.csv", "out/plan.json", "--columns-b", "names.yaml"}), 1,
                {"--columns-b is given, but 'out/plan.json' is not a CSV file"});
}

TEST_F(Exchange, TrajectoriesComeBackFromBothLanguages) {
  for (const char* language : {"yaml", "json"}) {
    const std::string file = std::string("trajectory.") + language;
    ASSERT_EQ(Run({"export", "out/plan.json", "--format", std::string("joint-trajectory-") + language, "--out", file,
                   "--quiet"})
                  .status,
              0);
    const Ran ran = Run({"import", file, "--robot", "a1", "--out", "again.json", "--json"});
    ASSERT_TRUE(ran.status == 0 || ran.status == 3) << ran.err;
    EXPECT_EQ(ran.json().at("format"), "joint-trajectory") << language;
  }
  Write("broken.json", Read("trajectory.json").substr(0, 2000));
  ExpectRefused(Run({"import", "broken.json", "--robot", "a1"}), 1, {"broken.json", "its JSON is cut short"});
}

TEST_F(Exchange, AJointTrajectoryIsComparedAsItIs) {
  for (const char* language : {"yaml", "json"}) {
    SCOPED_TRACE(language);
    const std::string file = std::string("trajectory.") + language,
                      format = std::string("joint-trajectory-") + language;
    ASSERT_EQ(Run({"export", "out/plan.json", "--format", format, "--out", file, "--quiet"}).status, 0);
    const Ran ran = Run({"compare", "out/plan.json", file, "--time-unit", "s", "--require-same", "--json"});
    ASSERT_EQ(ran.status, 0) << ran.out.substr(0, 600) << ran.err;
    EXPECT_EQ(ran.json().at("b").at("kind"), "trajectory");
    EXPECT_NEAR(ran.json().at("alignment").at("offset_s").get<double>(), 0.0, 1e-3);
    EXPECT_EQ(ran.json().at("joints").size(), 12U);
    EXPECT_EQ(Run({"compare", file, "slow.json", "--quiet"}).out, "different\n");
    ExpectRefused(Run({"compare", file, file}), 1, {"does not name the robot of the motion", "--robot NAME"});
  }
  Write("steps.yaml", "swing_s: 0.4\nfootsteps:\n- {foot: FL_foot, x_m: 0.22, y_m: 0.13}\n");
  ExpectRefused(Run({"compare", "out/plan.json", "steps.yaml"}), 1,
                {"'steps.yaml' is YAML, but not a joint trajectory", "'import' turns footsteps into a plan"});
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
