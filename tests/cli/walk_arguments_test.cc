// SPDX-License-Identifier: BSD-3-Clause
// Flags of a walk and its playback are read into requests, without planning.
#include "cli/walk_arguments.h"

#include <gtest/gtest.h>

#include "cli/command_line.h"
#include "tests/named_robot.h"

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
  /// The message of the refusal, from parsing or from filling the requests.
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

}  // namespace
}  // namespace gaitwright::cli
