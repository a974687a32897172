// SPDX-License-Identifier: BSD-3-Clause
// Files named by flags are read into requests.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "cli/json_text_internal.h"
#include "cli/options_file.h"
#include "cli/trials_arguments.h"
#include "tests/named_robot.h"
#include "tests/scratch_folder.h"
#include "workflows/walk/walk.h"

namespace gaitwright::cli {
namespace {

std::string OptionsFileWith(const std::string& text) {
  std::string path = ScratchFile("options.yaml");
  std::ofstream(path) << text;
  return path;
}

TEST(OptionsFiles, GiveOptionsThatTheVerbHasAndReturnAllOfThem) {
  WalkRequest walk;
  Common quiet;
  quiet.quiet = true;
  const OptionsFile file{OptionsFileWith("gait.cycle_s: 0.6\nplay.friction: 0.5\n")};
  const Result<OptionTexts> texts = file.Apply(walk.Fields(), quiet);
  ASSERT_TRUE(texts.ok()) << texts.failure().message;
  EXPECT_EQ(walk.gait_options.cycle_s, 0.6);
  EXPECT_EQ(texts->size(), 2U);
  EXPECT_TRUE(OptionsFile{}.Apply(walk.Fields(), quiet)->empty()) << "no file";
}

TEST(OptionsFiles, KeysOfOtherVerbsAreNotedUnlessQuiet) {
  WalkRequest walk;
  const OptionsFile file{OptionsFileWith("play.friction: 0.5\n")};
  testing::internal::CaptureStderr();
  ASSERT_TRUE(file.Apply(walk.Fields(), {}).ok());
  EXPECT_NE(testing::internal::GetCapturedStderr().find("play.friction"), std::string::npos);
  Common quiet;
  quiet.quiet = true;
  testing::internal::CaptureStderr();
  ASSERT_TRUE(file.Apply(walk.Fields(), quiet).ok());
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(OptionsFiles, UnknownKeysAreRefused) {
  WalkRequest walk;
  const OptionsFile file{OptionsFileWith("gait.cicle_s: 0.6\n")};
  const Result<OptionTexts> texts = file.Apply(walk.Fields(), {});
  ASSERT_FALSE(texts.ok());
  EXPECT_EQ(texts.failure().kind, FailureKind::kBadInput);
  EXPECT_NE(texts.failure().message.find("'gait.cycle_s'"), std::string::npos) << texts.failure().message;
}

std::string FileOfDisturbances(const std::string& text) {
  std::string path = ScratchFile("disturbances.yaml");
  std::ofstream(path) << text;
  return path;
}

TEST(DisturbanceFlags, AFileIsReadAndTheStandardSetLeavesOutWhatIsSet) {
  const RobotModel model = NamedRobot("a1");
  const Result<Disturbances> read =
      DisturbanceArguments{FileOfDisturbances("mass_scale: {uniform: [0.8, 1.2]}\n")}.Load(model, {});
  ASSERT_TRUE(read.ok()) << read.failure().message;
  ASSERT_EQ(read->figures.size(), 1U);
  EXPECT_EQ(read->figures[0].key, "mass_scale");
  const Result<Disturbances> standard = DisturbanceArguments{"standard"}.Load(model, {}),
                             besides = DisturbanceArguments{}.Load(model, {}, {"play.ground_slope_deg"});
  ASSERT_TRUE(standard.ok() && besides.ok());
  const auto draws_slope = [](const Disturbances& set) {
    for (const Disturbance& figure : set.figures) {
      if (figure.key == "ground_slope_deg") return true;
    }
    return false;
  };
  EXPECT_TRUE(draws_slope(*standard));
  EXPECT_FALSE(draws_slope(*besides)) << "a study varies it";
}

TEST(DisturbanceFlags, WhatAStudyVariesIsNotDrawnToo) {
  const Result<Disturbances> twice = DisturbanceArguments{FileOfDisturbances("friction: {uniform: [0.5, 0.9]}\n")}.Load(
      NamedRobot("a1"), {}, {"play.friction"});
  ASSERT_FALSE(twice.ok());
  EXPECT_EQ(twice.failure().code, FailureCode::kInVain);
  EXPECT_NE(twice.failure().message.find("friction"), std::string::npos);
}

TEST(JsonTexts, BytesThatAreNoTextAreReplacedAndTheRestIsReadBack) {
  const nlohmann::ordered_json json = {{"b", 1}, {"a", "x\xFFy"}};
  const std::string text = JsonText(json);
  const nlohmann::ordered_json back = ParsedJson(text);
  EXPECT_EQ(back.at("a"), "x\xEF\xBF\xBDy");
  EXPECT_EQ(back.begin().key(), "b") << "the order is kept";
  EXPECT_THROW(ParsedJson("{"), nlohmann::json::parse_error);
  testing::internal::CaptureStdout();
  PrintJson(back);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), JsonText(back) + "\n");
}

}  // namespace
}  // namespace gaitwright::cli
