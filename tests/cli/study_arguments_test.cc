// SPDX-License-Identifier: BSD-3-Clause
// Flags that sweep and tune share: a varied option must not be set as well.
#include "cli/study_arguments.h"

#include <gtest/gtest.h>

#include "cli/command_line.h"
#include "tests/named_robot.h"

namespace gaitwright::cli {
namespace {

/// A verb with the flags of a study.
class StudyProgram {
 public:
  StudyProgram() {
    study.AddTo(verb_, "What varies.");
    study.AddWorkTo(verb_);
    AddCommon(verb_, common, {"study"});
    AddOptionFlags(verb_, study.Fields(), common.sets, common.json);
  }
  /// The message of the refusal for an axis with these ends; "" if the words are accepted.
  std::string Refusal(const std::string& key, std::vector<std::string> words) {
    words.insert(words.begin(), {"gaitwright", "study", "--over", key + "=1:2"});
    std::vector<const char*> argv;
    for (const std::string& word : words) argv.push_back(word.c_str());
    StudyAxis axis;
    axis.key = key;
    axis.low = 0.1;
    axis.high = 0.2;
    try {
      line_.Run(static_cast<int>(argv.size()), argv.data());
      const Result<OptionTexts> texts = study.Finish({axis}, common);
      if (!texts) return texts.failure().message;
      const Result<RobotModel> model = study.FinishFor({axis});
      if (!model) return model.failure().message;
    } catch (const std::exception& error) {
      return error.what();
    }
    return "";
  }

  StudyArguments study;
  Common common;

 private:
  CommandLine line_{"a program", "its end"};
  Verb verb_ = line_.program().AddVerb("study", "Studies.");
};

std::string RefusedStudy(const std::string& key, const std::vector<std::string>& words) {
  return StudyProgram().Refusal(key, words);
}

struct GivenTwice {
  const char *flag, *value, *key;
};

class StudyFlagsTest : public testing::TestWithParam<GivenTwice> {};

TEST_P(StudyFlagsTest, WhatIsVariedIsNotGivenToo) {
  const auto& [flag, value, key] = GetParam();
  EXPECT_EQ(RefusedStudy(key, {flag, value}),
            std::string(flag) + " sets what --over " + key + " varies; leave one of them out");
}

INSTANTIATE_TEST_SUITE_P(Flags, StudyFlagsTest,
                         testing::Values(GivenTwice{"--speed", "0.2", "speed"},
                                         GivenTwice{"--lateral-speed", "0.1", "lateral_speed"},
                                         GivenTwice{"--yaw-rate", "0.3", "yaw_rate"},
                                         GivenTwice{"--com-method", "preview", "centre_of_mass.method"},
                                         GivenTwice{"--push", "0,20,0", "play.push_force_y_n"},
                                         GivenTwice{"--friction", "0.5", "play.friction"},
                                         GivenTwice{"--mass-scale", "1.1", "play.mass_scale"}));

TEST(StudyArgumentsTest, AnotherComponentOfAPushIsAnotherOption) {
  EXPECT_EQ(RefusedStudy("play.push_force_y_n", {"--push", "5,0,0", "--push-at", "1"}), "");
}

TEST(StudyArgumentsTest, SetCountsAsGiven) {
  const std::string why = RefusedStudy("gait.cycle_s", {"--set", "gait.cycle_s=0.6"});
  EXPECT_EQ(why, "--set gait.cycle_s=0.6 sets what --over gait.cycle_s varies; leave one of them out");
  EXPECT_EQ(RefusedStudy("gait.cycle_s", {"--set", "gait.duty_factor=0.6"}), "");
}

TEST(StudyArgumentsTest, StepLengthsNeedStepsAndSequencesHaveSpeedsOfTheirOwn) {
  EXPECT_NE(RefusedStudy("step_length", {}).find("give --steps too"), std::string::npos);
  EXPECT_EQ(RefusedStudy("step_length", {"--steps", "4"}), "");
  EXPECT_NE(RefusedStudy("speed", {"--sequence", "trot"}).find("set their own speeds"), std::string::npos);
}

// The axis counts as given when the extent is computed, but each point sets its own value.
TEST(StudyArgumentsTest, AVariedSpeedIsLeftToThePoints) {
  StudyProgram program;
  EXPECT_EQ(program.Refusal("speed", {"--distance", "0.5", "--lateral-speed", "0.05"}), "");
  const WalkCommand& command = program.study.walk.request.command;
  EXPECT_EQ(command.speed_m_s, 0.0);
  EXPECT_EQ(command.lateral_speed_m_s, 0.05);
  EXPECT_EQ(command.distance_m, 0.5);
}

TEST(StudyArgumentsTest, TheSeedGoesToPlanAndPlayback) {
  StudyProgram program;
  EXPECT_EQ(program.Refusal("speed", {"--seed", "7"}), "");
  EXPECT_EQ(program.study.walk.request.seed, 7U);
  EXPECT_EQ(program.study.play.request.play.world.seed, 7);
  EXPECT_EQ(program.study.play.request.sensing.sensors.seed, 7);
}

TEST(StudyArgumentsTest, AGaitThatDoesNotExistIsSaidOnce) {
  EXPECT_NE(RefusedStudy("speed", {"--gait", "trott"}).find("trott"), std::string::npos);
}

}  // namespace
}  // namespace gaitwright::cli
