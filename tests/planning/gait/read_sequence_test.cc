// SPDX-License-Identifier: BSD-3-Clause
#include "planning/gait/read_sequence.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>

#include "tests/scratch_folder.h"

namespace gaitwright {
namespace {

using Extent = WalkCommand::Extent;

std::vector<AskedPart> Expected() {
  std::vector<AskedPart> parts = {{"trot", {}}, {"stand", {}}, {"my.yaml:hop", {}}, {"walk", {}}};
  parts[0].command.speed_m_s = 1.5;
  parts[0].command.distance_m = 2.0;
  parts[1].command.extent = Extent::kDuration;
  parts[1].command.duration_s = 1.0;
  parts[2].command.extent = Extent::kSteps;
  parts[2].command.steps = 8;
  parts[2].command.step_length_m = -0.05;
  parts[3].command.yaw_rate_rad_s = -0.5;
  parts[3].command.lateral_speed_m_s = 0.1;
  parts[3].command.distance_m = 1.0;
  return parts;
}

/// The reason why a text is refused; empty if it is accepted.
std::string Why(const std::string& text) {
  const auto parts = ReadSequence(text);
  if (parts.ok()) return "";
  EXPECT_EQ(parts.failure().kind, FailureKind::kBadInput);
  return parts.failure().message;
}

std::string ReasonFile(const std::string& text) {
  const std::string path = ScratchFile("sequence_test.yaml");
  std::ofstream(path) << text;
  std::string why = Why(path);
  std::remove(path.c_str());
  return why;
}

TEST(ReadSequence, OfAText) {
  const auto parts = ReadSequence(
      "trot:speed=1.5,distance=2; stand: duration = 1;my.yaml:hop: steps=8, step-length=-0.05 ; "
      "walk: yaw-rate=-0.5,lateral-speed=0.1");
  ASSERT_TRUE(parts.ok()) << parts.failure().message;
  EXPECT_EQ(*parts, Expected());
}

TEST(ReadSequence, OfAFileIsThatOfTheText) {
  const std::string path = ScratchFile("sequence_test.yaml");
  std::ofstream(path) << "- {gait: trot, speed: 1.5, distance: 2}\n- gait: stand\n  duration: 1\n"
                         "- {gait: 'my.yaml:hop', steps: 8, step-length: -0.05}\n"
                         "- {gait: walk, yaw-rate: -0.5, lateral-speed: 0.1}\n";
  EXPECT_EQ(SequenceFileOf(path), path);
  const auto parts = ReadSequence(path);
  std::remove(path.c_str());
  ASSERT_TRUE(parts.ok()) << parts.failure().message;
  std::vector<AskedPart> expected = Expected();
  expected[2].gait = ScratchFile("my.yaml:hop");
  EXPECT_EQ(*parts, expected);
}

TEST(ReadSequence, WithoutAnExtentAPartGoesAMetreOrAQuarterTurn) {
  EXPECT_EQ(ReadSequence("trot").value().front().command.distance_m, 1.0);
  EXPECT_EQ(ReadSequence("trot:yaw-rate=1").value().front().command.distance_m, 0.0);
}

TEST(ReadSequence, WhatIsWrongIsNamed) {
  const std::vector<std::pair<std::string, std::string>> wrong = {
      {"trot;", "part 2 is empty"},
      {"trot; bound:sped=1", "part 2, 'bound': unknown option 'sped'; the nearest is 'speed'"},
      {"trot:speed=fast", "part 1, 'trot': option 'speed'"},
      {"trot:speed=-51", "part 1, 'trot': option 'speed' is -51"},
      {"trot:speed=1,speed=2", "'speed' is given twice"},
      {"speed=1", "has no gait before it"},
      {"trot:distance=1,steps=4", "'distance', 'steps' each set the distance"},
      {"trot:distance=0", "it must be more than 0"},
      {"trot:steps=4", "'steps' alone"},
      {"trot:step-length=0.1", "'step-length' is for use with 'steps'"},
      {"stand", "the time to stand is missing"},
      {"stand:speed=1", "'speed' does not apply to standing still"}};
  for (const auto& [text, part] : wrong)
    EXPECT_NE(Why(text).find(part), std::string::npos) << text << ": " << Why(text);
  const std::vector<std::pair<std::string, std::string>> wrong_files = {
      {"{gait: trot}", "contains no sequence"},
      {"- trot", "line 1: a part is a single value; a map of keys"},
      {"- {gait: trot}\n- {speed: 1}", "line 2: a part lacks the key 'gait'"},
      {"- {gait: trot}\n- {gait: bound, sped: 1}", "line 2: 'bound': unknown option 'sped'"},
      {"- {gait: trot, speed: [1]}", "line 1: 'speed' is a list"},
      {"- {gait: trot, speed: 1, speed: 2}", "'speed' twice"},
      {"- {gait: trot", "not valid YAML"}};
  for (const auto& [text, part] : wrong_files)
    EXPECT_NE(ReasonFile(text).find(part), std::string::npos) << text << ": " << ReasonFile(text);
  EXPECT_NE(Why("no_such_file.yaml"), "");
}

}  // namespace
}  // namespace gaitwright
