// SPDX-License-Identifier: BSD-3-Clause
#include "cli/compare_input.h"

#include <fstream>

#include "tests/cli/exchanged.h"
#include "tests/scratch_folder.h"

namespace gaitwright::cli {
namespace {

TEST_F(Exchange, ACsvIsComparedInTheOrderAndUnitsThatAreSaid) {
  ASSERT_EQ(Run({"export", "out/plan.json", "--out", "motion.csv", "--quiet"}).status, 0);
  const std::string motion = Read("motion.csv"), head = motion.substr(0, motion.find('\n'));
  const std::string ours = "base_qx,base_qy,base_qz,base_qw";
  const std::size_t at = head.find(ours);
  ASSERT_NE(at, std::string::npos);
  // The columns named x, y, z, w contain w, x, y, z.
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

/// The path of a new file with a text.
std::string ComparedFile(const std::string& name, const std::string& text) {
  std::string path = ScratchFile(name);
  std::ofstream(path) << text;
  return path;
}

void ExpectInputRefused(const CompareFiles& files, FailureCode code, const std::string& part) {
  const Result<CompareInput> input = ReadCompareInput(files);
  ASSERT_FALSE(input.ok()) << part;
  EXPECT_EQ(input.failure().kind, FailureKind::kBadInput);
  EXPECT_EQ(input.failure().code, code) << input.failure().message;
  EXPECT_NE(input.failure().message.find(part), std::string::npos) << input.failure().message;
}

TEST(CompareInputs, WhatIsNoMotionIsRefusedByWhatItIs) {
  const std::string table = ComparedFile("table.csv", "time_s,battery\n0,1\n1,1\n");
  const auto with = [&](const std::string& file) {
    CompareFiles files;
    files.a = file;
    files.b = table;
    return files;
  };
  ExpectInputRefused(with(ComparedFile("empty.json", "{}")), FailureCode::kNoMotion, "not a plan, log or report");
  ExpectInputRefused(with(ComparedFile("steps.yaml", "swing_s: 0.4\nfootsteps: []\n")), FailureCode::kNoMotion,
                     "is YAML, but not a joint trajectory");
  ExpectInputRefused(with(table), FailureCode::kNoRobot, "does not name the robot of the motion");
}

TEST(CompareInputs, NamesOfColumnsAreForTables) {
  CompareFiles files;
  files.a = ComparedFile("a.csv", "time_s,battery\n0,1\n1,1\n");
  files.b = ComparedFile("trials.yaml", "joint_names: [a]\npoints: []\n");
  files.columns_b = "names.yaml";
  EXPECT_THROW(
      {
        const Result<CompareInput> input = ReadCompareInput(files);
        if (!input) throw InvalidArgument(input.failure().message);
      },
      InvalidArgument);
}

TEST(CompareInputs, AFileThatIsNotThereIsNamed) {
  CompareFiles files;
  files.a = "/nowhere/a.json";
  files.b = "/nowhere/b.json";
  const Result<CompareInput> input = ReadCompareInput(files);
  ASSERT_FALSE(input.ok());
  EXPECT_NE(input.failure().message.find("/nowhere/a.json"), std::string::npos);
}

}  // namespace
}  // namespace gaitwright::cli
