// SPDX-License-Identifier: BSD-3-Clause
// The verb `import`: output, files and refusals.
#include <algorithm>

#include "tests/cli/stranger.h"

namespace gaitwright::cli {
namespace {

class Import : public Stranger {
 protected:
  /// A plan of the program as a CSV: its header and its rows.
  std::string Motion() const {
    MakePlan("plan.json");
    const Ran ran = Run({"export", "plan.json", "--format", "csv", "--out", "motion.csv", "--quiet"});
    EXPECT_EQ(ran.status, 0) << ran.err;
    return Read("motion.csv");
  }

  static std::string With(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return at == std::string::npos ? text : text.replace(at, from.size(), to);
  }
};

TEST_F(Import, MakesAPlanThatAuditAndPlayTake) {
  Motion();
  const Ran ran = Run({"import", "motion.csv", "--out", "new/imported.json", "--json"});
  ASSERT_EQ(ran.status, 0) << ran.err;
  const Json json = ran.json();
  EXPECT_EQ(json.at("robot"), "a1");
  EXPECT_EQ(json.at("verdict"), "pass");
  EXPECT_EQ(json.at("format"), "csv");
  EXPECT_GT(json.at("rows"), 100);
  EXPECT_GT(json.at("duration_s"), 1.0);
  EXPECT_GT(json.at("footholds"), 4);
  EXPECT_GT(json.at("derived").size(), 2U);
  EXPECT_TRUE(json.at("derived").front().at("how").is_string());
  EXPECT_TRUE(json.at("unused_columns").is_array() && json.at("warnings").is_array());
  EXPECT_EQ(json.at("audit").at("verdict"), "pass");
  EXPECT_EQ(json.at("files").at("plan"), "new/imported.json");
  EXPECT_EQ(Run({"audit", "new/imported.json", "--quiet"}).out, "pass\n");
  EXPECT_EQ(Run({"play", "new/imported.json", "--quiet"}).out, "pass\n");
  const Ran words = Run({"import", "motion.csv"});
  EXPECT_NE(words.out.find("derived: footholds: "), std::string::npos) << words.out;
  EXPECT_EQ(Run({"import", "motion.csv", "--quiet"}).out, "pass\n");
}

TEST_F(Import, AMotionThatWasExportedAtAnyRatePassesAgain) {
  ASSERT_EQ(Run({"plan", "--robot", "a1", "--distance", "0.4", "--out", "plan.json", "--quiet"}).status, 0);
  for (const char* rate_hz : {"300", "500", "1000"}) {  // the first two end early
    SCOPED_TRACE(rate_hz);
    ASSERT_EQ(Run({"export", "plan.json", "--rate-hz", rate_hz, "--out", "motion.csv", "--quiet"}).status, 0);
    const Ran ran = Run({"import", "motion.csv", "--out", "again.json", "--json"});
    EXPECT_EQ(ran.status, 0) << ran.out.substr(0, 2000) << ran.err;
    const Json report = ran.json();
    for (const Json& part : report.at("derived")) EXPECT_NE(part.at("what"), "rows") << part;
    EXPECT_EQ(Run({"audit", "again.json", "--quiet"}).out, "pass\n");
  }
}

TEST_F(Import, LeavesAPlanThatLiesThereAlone) {
  Motion();
  const std::string plan = Read("plan.json");
  EXPECT_EQ(Run({"import", "motion.csv", "--quiet"}).out, "pass\n");
  EXPECT_TRUE(Read("plan.json") == plan);
  EXPECT_TRUE(std::filesystem::is_regular_file(In("imported.json")));
}

TEST_F(Import, TellsAPlanOfItsOwnAndAFolder) {
  MakePlan("plan.json");
  ExpectRefused(Run({"import", "plan.json"}), 1, {"'plan.json': is a plan of this program", "'audit', 'play'"});
  ExpectRefused(Run({"import", "."}), 1, {"'.': is a folder"});
  EXPECT_EQ(Found(), std::vector<std::string>{"plan.json"});
}

TEST_F(Import, RefusesWithTheReasonAndWritesNothing) {
  const std::string motion = Motion();
  Write("names.csv", With(motion, "q_FL_hip_joint_rad", "q_FL_hop_joint_rad"));
  ExpectRefused(Run({"import", "names.csv", "--out", "x.json"}), 1,
                {"names.csv", "'q_FL_hop_joint_rad' is unknown for robot 'a1'; the nearest is 'q_FL_hip_joint_rad'"});
  ExpectRefused(Run({"import", "motion.csv", "--robot", "nao", "--out", "x.json"}), 1, {"unknown for robot 'nao'"});
  ExpectRefused(Run({"import", "none.csv", "--out", "x.json"}), 1, {"none.csv"});
  ExpectRefused(Run({"import", "motion.csv", "--columns", "none.yaml", "--out", "x.json"}), 1, {"none.yaml"});
  ExpectRefused(Run({"import", "motion.csv", "--set", "lift_m=0.1", "--out", "x.json"}), 1,
                {"over the ground in most rows"});
  ExpectRefused(Run({"import", "motion.csv", "--set", "grid_step_s=1e-9", "--out", "x.json"}), 1,
                {"'grid_step_s' is 1e-09 s; accepted: 0, and 0.0005 to 0.01"});
  ExpectRefused(Run({"import", "motion.csv", "--out", "motion.csv"}), 1, {"motion.csv"});
  ExpectRefused(Run({"import", "motion.csv", "--goal", "1,2", "--out", "x.json"}), 1, {"--goal", "3 numbers"});
  const std::vector<std::string> found = Found();
  EXPECT_EQ(std::count(found.begin(), found.end(), "x.json"), 0);
}

TEST_F(Import, ColumnsMayBeNamedInAFile) {
  const std::string motion = Motion();
  Write("theirs.csv", With(With(motion, "time_s", "clock"), "q_FL_hip_joint_rad", "hip"));
  Write("names.yaml", "columns: {clock: time_s, hip: q_FL_hip_joint_rad}\n");
  const Ran ran = Run({"import", "theirs.csv", "--columns", "names.yaml", "--out", "theirs.json", "--quiet"});
  EXPECT_EQ(ran.out, "pass\n") << ran.err;
  Write("misspelt.yaml", "columns: {clok: time_s, hip: q_FL_hip_joint_rad}\n");
  ExpectRefused(Run({"import", "theirs.csv", "--columns", "misspelt.yaml", "--out", "x.json"}), 1,
                {"there is no column 'clok' to take as 'time_s'; the nearest is 'clock'"});
}

TEST_F(Import, FootstepsAreAPlanToo) {
  Write("steps.yaml", "swing_s: 0.4\npause_s: 0.3\nfootsteps:\n- {foot: FL_foot, x_m: 0.22, y_m: 0.13}\n");
  const Ran ran = Run({"import", "steps.yaml", "--out", "steps.json", "--json"});
  ASSERT_EQ(ran.status, 0) << ran.err;
  EXPECT_EQ(ran.json().at("format"), "footsteps");
  EXPECT_EQ(ran.json().at("rows"), 1);
}

}  // namespace
}  // namespace gaitwright::cli
