// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/base/options_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/scratch_folder.h"

namespace gaitwright {
namespace {

class OptionsFiles : public testing::Test {
 protected:
  OptionsFiles() : path_(ScratchFile("options.yaml")) {}
  ~OptionsFiles() override { std::filesystem::remove(path_); }

  Result<OptionTexts> Load(const std::string& text) {
    std::ofstream(path_) << text;
    return LoadOptionsFile(path_.string(), {{"gait.cycle_s", &cycle_s_, "s", 0.0, 2.0, "Time.", {}},
                                            {"count", &count_, "1", 1.0, 9.0, "Number.", {}},
                                            {"on", &on_, "", 0.0, 0.0, "Switch.", {}},
                                            {"place", &place_, "", 0.0, 0.0, "Word.", {"base", "robot"}}});
  }
  void ExpectRefused(const std::string& text, const std::string& part) {
    const Result<OptionTexts> texts = Load(text);
    ASSERT_FALSE(texts) << text;
    EXPECT_EQ(texts.failure().code, FailureCode::kOptionsFile);
    EXPECT_NE(texts.failure().message.find("'" + path_.string() + "', " + part), std::string::npos)
        << texts.failure().message;
  }

  std::filesystem::path path_;
  double cycle_s_ = 0.5;
  int count_ = 3;
  bool on_ = false;
  std::string place_ = "base";
};

TEST_F(OptionsFiles, GiveKeysAndValuesInTheirOrder) {
  const Result<OptionTexts> texts = Load("# tuned\non: true\ngait.cycle_s: 0.40\nplace: robot\ncount: 4\n");
  ASSERT_TRUE(texts) << texts.failure().message;
  EXPECT_EQ(*texts, (OptionTexts{{"on", "true"}, {"gait.cycle_s", "0.4"}, {"place", "robot"}, {"count", "4"}}));
}

TEST_F(OptionsFiles, WhatIsNotRightIsRefusedByItsLine) {
  ExpectRefused("", "line 1: contains no options");
  ExpectRefused("- 1\n- 2\n", "line 1: contains no options");
  ExpectRefused("on: true\ngait.cycle: 0.4\n", "line 2: unknown option 'gait.cycle'; the nearest is 'gait.cycle_s'");
  ExpectRefused("gait.cycle_s: 3\n", "line 1: option 'gait.cycle_s' is 3 s; accepted: 0 to 2");
  ExpectRefused("gait.cycle_s: .nan\n", "line 1: option 'gait.cycle_s' is '.nan', which is not a number");
  ExpectRefused("count: 2.5\n", "line 1: option 'count' is '2.5', which is not a whole number");
  ExpectRefused("on: yes\n", "line 1: option 'on' is 'yes'; accepted: true, false");
  ExpectRefused("place: leg\n", "line 1: option 'place' is 'leg'; accepted: 'base', 'robot'");
  ExpectRefused("gait.cycle_s: [1, 2]\n", "line 1: option 'gait.cycle_s' is a list");
  ExpectRefused("gait:\n  cycle_s: 0.4\n", "line 2: option 'gait' is a map");
  ExpectRefused("count: 2\ncount: 3\n", "line 2:");
  ExpectRefused("count: \"2\n", "line");
  ExpectRefused("count: " + std::string(100, '[') + std::string(100, ']'),
                "line 1: lists and maps are nested more than 32 levels");
}

TEST_F(OptionsFiles, AFileThatIsNotThereIsNamed) {
  const Result<OptionTexts> texts = LoadOptionsFile("/none/of/it.yaml", {});
  ASSERT_FALSE(texts);
  EXPECT_NE(texts.failure().message.find("/none/of/it.yaml"), std::string::npos);
}

}  // namespace
}  // namespace gaitwright
