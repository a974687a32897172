// SPDX-License-Identifier: BSD-3-Clause
// Flags that verbs share are read into requests, without planning anything.
#include <gtest/gtest.h>

#include <fstream>

#include "cli/command_line.h"
#include "cli/json_text_internal.h"
#include "cli/options_file.h"
#include "cli/trials_arguments.h"
#include "cli/walk_arguments.h"
#include "nlohmann/json.hpp"
#include "tests/named_robot.h"
#include "tests/scratch_folder.h"

namespace gaitwright::cli {
namespace {

/// A verb with the flags of a walk and its playback.
class WalkProgram {
 public:
  WalkProgram() {
    walk.AddTo(verb_);
    play.AddTo(verb_);
  }
  void Read(std::vector<std::string> words) {
    words.insert(words.begin(), {"gaitwright", "walk"});
    std::vector<const char*> argv;
    for (const std::string& word : words) argv.push_back(word.c_str());
    line_.Run(static_cast<int>(argv.size()), argv.data());
  }
  /// What the words are refused with, as a usage or when they are put into the requests.
  std::string Refusal(const std::vector<std::string>& words) {
    try {
      Read(words);
      walk.Finish(NamedRobot("a1"));
      play.Finish();
    } catch (const std::exception& error) {
      return error.what();
    }
    return "";
  }

  WalkArguments walk;
  PlayArguments play;

 private:
  CommandLine line_{"a program", "its end"};
  Verb verb_ = line_.program().AddVerb("walk", "Walks.");
};

std::string RefusedFlags(const std::vector<std::string>& words) { return WalkProgram().Refusal(words); }

TEST(WalkFlags, SpeedsAndExtentGoIntoTheRequest) {
  WalkProgram program;
  EXPECT_EQ(program.Refusal({"--gait", "trot", "--speed", "0.4", "--yaw-rate", "-0.2", "--distance", "2.5"}), "");
  EXPECT_EQ(program.walk.request.gait, "trot");
  EXPECT_EQ(program.walk.request.command.speed_m_s, 0.4);
  EXPECT_EQ(program.walk.request.command.yaw_rate_rad_s, -0.2);
  EXPECT_EQ(program.walk.request.command.extent, WalkCommand::Extent::kDistance);
  EXPECT_EQ(program.walk.request.command.distance_m, 2.5);
}

TEST(WalkFlags, AGoalIsThreeNumbers) {
  WalkProgram program;
  EXPECT_EQ(program.Refusal({"--goal", "1.5,-0.5,0.25"}), "");
  EXPECT_EQ(program.walk.request.command.extent, WalkCommand::Extent::kGoal);
  EXPECT_EQ(program.walk.request.command.goal_y_m, -0.5);
  EXPECT_NE(RefusedFlags({"--goal", "1,2"}).find("--goal: expects 3 numbers"), std::string::npos);
}

TEST(WalkFlags, OneExtentIsEnoughAndAStepLengthNeedsSteps) {
  EXPECT_NE(RefusedFlags({"--distance", "1", "--duration", "2"}), "");
  EXPECT_NE(RefusedFlags({"--step-length", "0.1"}).find("--steps"), std::string::npos);
  EXPECT_NE(RefusedFlags({"--steps", "4", "--step-length", "0.1", "--speed", "0.2"}), "");
  EXPECT_NE(RefusedFlags({"--sequence", "trot", "--speed", "0.2"}).find("--sequence"), std::string::npos);
  EXPECT_EQ(RefusedFlags({"--steps", "4", "--step-length", "0.1"}), "");
  EXPECT_NE(RefusedFlags({"--steps", "0"}), "");
}

TEST(WalkFlags, ARobotIsByItsNameOrOfAFile) {
  WalkProgram named, file;
  EXPECT_EQ(named.Refusal({"--robot", "nao"}), "");
  EXPECT_FALSE(named.walk.robot.is_file());
  EXPECT_EQ(file.Refusal({"--urdf", "robots/my.urdf", "--package", "p=/somewhere"}), "");
  EXPECT_TRUE(file.walk.robot.is_file());
  EXPECT_EQ(file.walk.robot.folder(), "robots");
  EXPECT_EQ(file.walk.robot.loading.packages.at("p"), "/somewhere");
  EXPECT_NE(RefusedFlags({"--robot", "nao", "--urdf", "my.urdf"}), "");
  EXPECT_NE(RefusedFlags({"--package", "no_equals"}).find("NAME=DIR"), std::string::npos);
  Paths paths;
  file.walk.robot.AddTo(paths);
  ASSERT_EQ(paths.read.size(), 2U);
  EXPECT_EQ(paths.read[0].name, "--urdf");
  EXPECT_EQ(paths.read[1].path, "robots/robot.yaml");
}

TEST(PlayFlags, APushIsAForceAndItsTimesNeedOne) {
  WalkProgram program;
  EXPECT_EQ(program.Refusal({"--push", "10,-20,0", "--push-at", "1.5"}), "");
  EXPECT_EQ(program.play.request.play.push_force_W, Vector3(10.0, -20.0, 0.0));
  EXPECT_EQ(RefusedFlags({"--push-at", "1.5"}), "--push-at is given without --push, which sets the force");
  EXPECT_NE(RefusedFlags({"--push", "10,0,0", "--push-for", "0"}).find("--push-for must be above 0"),
            std::string::npos);
  EXPECT_NE(RefusedFlags({"--push", "10"}).find("--push: expects 3 numbers"), std::string::npos);
}

TEST(PlayFlags, SensorsAreForStatesThatUseThem) {
  EXPECT_NE(RefusedFlags({"--sensors", "good"}).find("--sensors is for --state"), std::string::npos);
  EXPECT_EQ(RefusedFlags({"--sensors", "good", "--state", "measured"}), "");
  EXPECT_NE(RefusedFlags({"--sensors", "godo", "--state", "measured"}), "");
  WalkProgram varied;
  varied.Read({"--sensors", "good"});
  EXPECT_NO_THROW(varied.play.Finish({"state"})) << "a study varies the state";
}

TEST(PlayFlags, AnOptionWithoutAnEffectIsRefusedUnlessItIsUsual) {
  WalkProgram program;
  program.Read({"--controller", "joint-pd"});
  const std::string set = "stabilised.dcm_gain=2.75";
  ApplySets("--set", {set}, program.play.Fields());
  EXPECT_THROW(program.play.CheckActs({set}), InvalidArgument);
  EXPECT_NO_THROW(program.play.CheckActs({}));
  WalkProgram stabilised;
  ApplySets("--set", {set}, stabilised.play.Fields());
  EXPECT_NO_THROW(stabilised.play.CheckActs({set}));
}

std::string OptionsFileWith(const std::string& text) {
  const std::string path = ScratchFile("options.yaml");
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
  const std::string path = ScratchFile("disturbances.yaml");
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
