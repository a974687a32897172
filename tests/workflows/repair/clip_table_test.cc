// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "tests/named_robot.h"
#include "workflows/repair/clip_table_internal.h"

namespace gaitwright {
namespace {

std::vector<ClipOutcome> Outcomes() {
  ClipOutcome fails;
  fails.clip = "walk, fast.csv";
  fails.verdict = ClipVerdict::kFail;
  fails.duration_s = 3.5;
  fails.broken_share = 0.25;
  fails.broken = "joint_torque";
  fails.violations = 7;
  fails.joint_rms_rad = 0.03;
  fails.reason = "it \"fell\"";
  fails.plan = "out/walk, fast.csv.plan.json";
  ClipOutcome passes;
  passes.clip = "squat.csv";
  passes.verdict = ClipVerdict::kPass;
  passes.slowed_s = 0.5;
  passes.left_out_s = 1.25;
  return {fails, passes};
}

TEST(ClipTable, ALineReadsBack) {
  for (const ClipOutcome& outcome : Outcomes()) {
    const std::string line = LineOf(outcome);
    EXPECT_EQ(line.find('\n'), std::string::npos);
    EXPECT_EQ(ClipOfLine(line), outcome);
  }
  EXPECT_THROW(ClipOfLine("{}"), std::runtime_error);
  EXPECT_THROW(ClipOfLine("nothing"), std::runtime_error);
}

TEST(ClipTable, IsForPeopleAndPrograms) {
  const std::string text = ClipsText(Outcomes());
  EXPECT_NE(text.find("joint_torque; it \"fell\""), std::string::npos) << text;
  EXPECT_NE(text.find("1 of 2 pass, 1 fail, 0 refused\n"), std::string::npos) << text;
  const std::string csv = ClipsCsv(Outcomes());
  EXPECT_NE(csv.find("\"walk, fast.csv\",fail,3.5,0.25,joint_torque,7,0.03,0,0,0,0,\"it \"\"fell\"\"\","),
            std::string::npos)
      << csv;
  const auto json = nlohmann::json::parse(ClipsJson(NamedRobot("a1"), Outcomes(), "out/clips.csv"));
  EXPECT_EQ(json["verdict"], "fail");
  EXPECT_EQ(json["passed"], 1);
  EXPECT_EQ(json["clips"][0]["violations"], 7);
  EXPECT_EQ(json["files"]["table"], "out/clips.csv");
}

}  // namespace
}  // namespace gaitwright
