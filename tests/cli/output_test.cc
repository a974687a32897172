// SPDX-License-Identifier: BSD-3-Clause
// Output and files of `walk` and `play` for a synthetic playback.
#include "cli/output.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/playback/played.h"
#include "tests/scratch_folder.h"

namespace gaitwright::cli {
namespace {

using OutputJson = nlohmann::ordered_json;

/// A playback that passed, of a plan whose audit passes.
struct MadeJudged : synthetic::Played {
  MadeJudged() : Played(synthetic::Walked(2, {.count = 2})) {
    walk.log = log;
    walk.report = Score(model, plan, log);
    walk.report.pass = true;
    walk.report.score = 77.0;
    walk.realtime_factor = 2.5;
  }
  Judged Get() const { return {model, plan, walk, audit, 0.0, true}; }
  std::string Printed(const Common& common, const Files& files = {},
                      const std::vector<std::pair<std::string, std::string>>& more = {}) const {
    testing::internal::CaptureStdout();
    PrintJudged(Get(), files, common, more);
    std::fflush(stdout);
    return testing::internal::GetCapturedStdout();
  }

  PlayedWalk walk;
  AuditReport audit;
};

Common InJson() {
  Common common;
  common.json = true;
  return common;
}

TEST(Output, QuietIsTheVerdictAlone) {
  MadeJudged made;
  Common quiet;
  quiet.quiet = true;
  EXPECT_EQ(made.Printed(quiet), "pass\n");
  made.walk.report.pass = false;
  EXPECT_EQ(made.Printed(quiet), "fail\n");
  made.walk.report.pass = true;
  made.audit.violations = {{Law::kJointTorque, 0.5, "knee", 30.0, 25.0, "N m"}};
  EXPECT_EQ(made.Printed(quiet), "fail\n") << "the audit counts";
}

TEST(Output, JsonHasTheVerdictOfPlaybackAndAudit) {
  MadeJudged made;
  const OutputJson pass = OutputJson::parse(made.Printed(InJson(), {{"plan", "out/plan.json"}}, {{"first", "3"}}));
  EXPECT_EQ(pass.begin().key(), "first") << "what a verb adds stands before all else";
  EXPECT_EQ(pass["verdict"], "pass");
  EXPECT_EQ(pass["score"], 77.0);
  EXPECT_EQ(pass["playback_realtime_factor"], 2.5);
  EXPECT_EQ(pass["files"], (OutputJson{{"plan", "out/plan.json"}}));
  EXPECT_FALSE(pass.contains("engines"));
  made.audit.violations = {{Law::kJointTorque, 0.5, "knee", 30.0, 25.0, "N m"}};
  const OutputJson fail = OutputJson::parse(made.Printed(InJson()));
  EXPECT_EQ(fail["verdict"], "fail");
  EXPECT_EQ(fail["reason"], "the plan fails its audit: joint_torque");
}

TEST(Output, WithTwoEnginesTheOneThatFailsIsNamed) {
  MadeJudged made;
  SecondPlayback second;
  second.log = made.log;
  second.report = made.walk.report;
  second.report.pass = false;
  second.report.score = 12.0;
  second.report.reason = "it fell";
  made.walk.second = std::make_shared<const SecondPlayback>(second);
  const OutputJson json = OutputJson::parse(made.Printed(InJson()));
  ASSERT_EQ(json["engines"].size(), 2U);
  EXPECT_EQ(json["engines"][0]["score"], 77.0);
  EXPECT_EQ(json["engines"][1]["score"], 12.0);
  EXPECT_EQ(json["verdict"], "fail");
  EXPECT_EQ(json["score"], 12.0);
  EXPECT_EQ(json["reason"], "it fell");
}

TEST(Output, WhatATrialDrewIsShortInWordsAndWholeInJson) {
  MadeJudged made;
  made.walk.log.options = {{"trial.mass_scale", "0.90791234"},
                           {"trial.push1.place", "base"},
                           {"trial.start.joint.FR_rad", "0.01"},
                           {"play.friction", "0.5"}};
  EXPECT_NE(made.Printed({}).find("drawn: mass_scale 0.9079, push1.place base\n"), std::string::npos);
  const OutputJson drawn = OutputJson::parse(made.Printed(InJson()))["drawn"];
  EXPECT_EQ(drawn["mass_scale"], "0.90791234");
  EXPECT_EQ(drawn["start.joint.FR_rad"], "0.01");
  EXPECT_FALSE(drawn.contains("play.friction"));
}

TEST(Output, FilesAreWrittenWhereTheyAreNamed) {
  const MadeJudged made;
  Outputs outputs;
  outputs.folder = ScratchFile("outputs");
  outputs.log = outputs.report = "";
  EXPECT_EQ(outputs.PathOf(""), "");
  const Result<Files> files = WriteOutputs(made.Get(), outputs);
  ASSERT_TRUE(files.ok()) << files.failure().message;
  ASSERT_EQ(files->size(), 1U);
  EXPECT_EQ(files->front().first, "plan");
  EXPECT_EQ(files->front().second, outputs.PathOf("plan.json"));
  EXPECT_TRUE(std::filesystem::is_regular_file(files->front().second));
}

}  // namespace
}  // namespace gaitwright::cli
