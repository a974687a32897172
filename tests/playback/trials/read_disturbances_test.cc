// SPDX-License-Identifier: BSD-3-Clause
// Disturbances as YAML: reading, writing, and refusals with their line.
#include <gtest/gtest.h>

#include "playback/trials/disturbances.h"
#include "playback/trials/disturbances_shape.h"
#include "tests/playback/standing_plan.h"

namespace gaitwright {
namespace {

double read_noise = 0.0;  // of the sensors
int read_seed = 0;
const OptionFields kReadSensors = {{"noise_rad", &read_noise, "rad", 0.0, 0.1, "", {}},
                                   {"seed", &read_seed, "1", 0, 10, "", {}}};

Disturbances ReadText(const std::string& text) { return ReadDisturbances(text, kReadSensors, "d.yaml").value(); }

std::string RefusalOfText(const std::string& text) {
  const auto read = ReadDisturbances(text, kReadSensors, "d.yaml");
  EXPECT_FALSE(read.ok()) << text;
  if (read.ok()) return "";
  EXPECT_EQ(read.failure().kind, FailureKind::kBadInput);
  EXPECT_EQ(read.failure().code, FailureCode::kDisturbances);
  return read.failure().message;
}

/// The distribution of the only quantity in a text.
Distribution OnlyFigure(const std::string& text) {
  const Disturbances read = ReadText(text);
  EXPECT_EQ(read.figures.size(), 1U);
  return read.figures.at(0).distribution;
}

TEST(ReadDisturbancesTest, EveryKeyIsReadAndWrittenBack) {
  std::string text;
  for (const DisturbanceRule& rule : DisturbanceRules()) {
    if (rule.key.find('.') != std::string::npos || rule.key.starts_with("com_shift_m")) continue;
    text += rule.key + ": {uniform: [" + std::to_string(rule.lowest) + ", " + std::to_string(rule.highest) + "]}\n";
  }
  text += "start:\n  x_m: 0.1\n  joints_rad: {normal: {mean: 0, std: 0.01}}\n";
  text += "sensors:\n  noise_rad: {choice: [0, 0.001]}\n";
  text += "pushes:\n  - size_n: {uniform: [0, 50]}\n    place: {choice: [base, robot, FR_calf]}\n    at_s: 1\n";
  const Disturbances disturbances = ReadText(text);
  ASSERT_EQ(disturbances.pushes.size(), 1U);
  const Disturbances quoted = ReadText("pushes:\n  - {size_n: 1, place: {choice: ['a: b', 'no', '1', 'x-y#']}}\n");
  EXPECT_EQ(ReadText(DisturbancesText(quoted)), quoted);
  EXPECT_EQ(disturbances.figures.back().key, "sensors.noise_rad");
  const std::string again = DisturbancesText(disturbances);
  EXPECT_EQ(DisturbancesText(ReadText(again)), again);
  EXPECT_EQ(ReadText(again).pushes, disturbances.pushes);
  EXPECT_EQ(ReadText(again).figures.size(), disturbances.figures.size());
}

TEST(ReadDisturbancesTest, RefusalsNameLineAndNearest) {
  const auto says = [](const std::string& text, const std::vector<std::string>& parts) {
    const std::string message = RefusalOfText(text);
    for (const std::string& part : parts) EXPECT_NE(message.find(part), std::string::npos) << part << ": " << message;
  };
  says("friction: 0.5\nmas_scale: 1\n", {"d.yaml", "line 2", "'mas_scale'", "'mass_scale'"});
  says("mass_scale: {uniform: [0.9]}\n", {"line 1", "2 are needed"});
  says("mass_scale: {uniform: [0.9, 11]}\n", {"mass_scale", "11", "0.1 to 10"});
  says("mass_scale: {uniform: [1.1, 0.9]}\n", {"line 1", "uniform distribution from 1.1 to 0.9"});
  says("mass_scale: {normal: {mean: 1}}\n", {"lacks the key 'std'"});
  says("mass_scale: {normal: {mean: 1, std: 0.001, lowest: 2, highest: 3}}\n", {"from 2 to 3: 0", "0.01 is needed"});
  says("mass_scale: {unifrm: [0.9, 1.1]}\n", {"'unifrm'", "'uniform'"});
  says("mass_scale: {uniform: [0.9, 1.1], fixed: 1}\n", {"2 keys", "give exactly one"});
  says("mass_scale: {choice: []}\n", {"a choice ", "one or more are needed"});
  says("mass_scale: heavy\n", {"'heavy'", "a number is needed"});
  says("mass_scale: .nan\n", {"finite"});
  says("mass_scale: 1\nmass_scale: 2\n", {"twice"});
  says("com_shift_m: 0.01\ncom_shift_x_m: 0.01\n", {"com_shift_m", "com_shift_x_m"});
  says("start: {rol_rad: 0.1}\n", {"'rol_rad'", "'roll_rad'"});
  says("sensors: {noise: 0.1}\n", {"'noise'", "'noise_rad'"});
  says("sensors: {seed: 1}\n", {"'seed'"});
  says("pushes:\n  - direction_deg: 90\n", {"has no size"});
  says("pushes:\n  - {size_n: 1, size_of_weight: 0.1}\n", {"size_n", "size_of_weight"});
  says("pushes:\n  - {size_n: 1, at_s: 1, at_share: 0.5}\n", {"at_s", "at_share"});
  says("pushes:\n  - {size_n: 1, place: {uniform: [0, 1]}}\n", {"words are needed"});
  says("pushes: {size_n: 1}\n", {"a list is needed"});
  says("", {"contains no disturbances"});
  says("pushes: []\nstart: {}\n", {"contains no disturbances"});
  says("bump_seed: 1.5\n", {"line 1", "bump_seed is 1.5", "whole number"});
  says("bump_seed: {choice: [1, 2.5]}\n", {"2.5", "whole number"});
  says("bump_seed: {uniform: [0, 3.5]}\n", {"3.5", "whole number"});
  says("a: [", {"not valid YAML"});
}

TEST(ReadDisturbancesTest, APushWithoutImpulseIsNone) {
  for (const char* duration :
       {"0", "{uniform: [0, 0.2]}", "{choice: [0.1, 0]}", "{normal: {mean: 0, std: 1, lowest: 0}}"}) {
    const std::string why = RefusalOfText("pushes:\n  - {size_n: 3000, duration_s: " + std::string(duration) + "}\n");
    EXPECT_NE(why.find("line 2: duration_s"), std::string::npos) << why;
    EXPECT_NE(why.find(" is 0; accepted: 0.0001 to 100"), std::string::npos) << why;
  }
}

TEST(ReadDisturbancesTest, TheStandardSetScalesAndReadsBack) {
  const RobotModel a1_model = standing::Load("a1");
  const RobotModel nao = standing::Load("nao");
  const Disturbances a1 = StandardDisturbances(a1_model);
  EXPECT_EQ(DisturbancesText(ReadText(DisturbancesText(a1))), DisturbancesText(a1));
  const auto bumps = [](const Disturbances& d) {
    for (const Disturbance& figure : d.figures) {
      if (figure.key == "ground_bumps_m") return figure.distribution.highest;
    }
    return 0.0;
  };
  EXPECT_NEAR(bumps(a1) / bumps(StandardDisturbances(nao)), a1_model.leg_length_m() / nao.leg_length_m(), 1e-9);
}

TEST(ReadDisturbancesTest, ABareValueIsAFixedOne) {
  EXPECT_EQ(OnlyFigure("mass_scale: 1.25\n"), Distribution::Fixed(1.25));
  EXPECT_EQ(OnlyFigure("mass_scale: {fixed: 1.25}\n"), Distribution::Fixed(1.25));
  EXPECT_EQ(ReadText("pushes:\n  - {size_n: 1, place: base}\n").pushes.at(0).at(1).distribution,
            ReadText("pushes:\n  - {size_n: 1, place: {choice: [base]}}\n").pushes.at(0).at(1).distribution);
}

// The default limits are at three standard deviations, but within the range of the quantity.
TEST(ReadDisturbancesTest, ABellEndsAtThreeDeviationsOrWhereItsFigureEnds) {
  const Distribution wide = OnlyFigure("mass_scale: {normal: {mean: 2, std: 0.5}}\n");
  EXPECT_EQ(wide.mean, 2.0);
  EXPECT_EQ(wide.std, 0.5);
  EXPECT_DOUBLE_EQ(wide.lowest, 0.5);
  EXPECT_DOUBLE_EQ(wide.highest, 3.5);
  const Distribution clamped = OnlyFigure("mass_scale: {normal: {mean: 1, std: 4, highest: 5}}\n");
  EXPECT_EQ(clamped.lowest, 0.1) << "the least that mass_scale accepts";
  EXPECT_EQ(clamped.highest, 5.0);
}

TEST(ReadDisturbancesTest, KeysOfGroupsHaveTheNameOfTheGroupBeforeThem) {
  const Disturbances read = ReadText("sensors: {noise_rad: 0.01}\nstart: {x_m: 0.1}\nfriction: 0.5\n");
  std::vector<std::string> keys;
  for (const Disturbance& figure : read.figures) keys.push_back(figure.key);
  EXPECT_EQ(keys, (std::vector<std::string>{"sensors.noise_rad", "start.x_m", "friction"})) << "in the file's order";
  EXPECT_EQ(DisturbancesText(read), "friction: 0.5\nstart:\n  x_m: 0.1\nsensors:\n  noise_rad: 0.01\n");
}

TEST(ReadDisturbancesTest, AHundredPushesAreTheMost) {
  std::string text = "pushes:\n";
  for (int i = 0; i < 100; ++i) text += "  - {size_n: 1}\n";
  EXPECT_EQ(ReadText(text).pushes.size(), 100U);
  const std::string why = RefusalOfText(text + "  - {size_n: 1}\n");
  EXPECT_NE(why.find("there are 101 pushes; at most 100 are accepted"), std::string::npos) << why;
}

TEST(ReadDisturbancesTest, AFileThatIsNotThereIsNamed) {
  const auto read = LoadDisturbances("/nowhere/d.yaml", kReadSensors);
  ASSERT_FALSE(read.ok());
  EXPECT_NE(read.failure().message.find("/nowhere/d.yaml"), std::string::npos);
}

// The handbook and the checkers of editors know the reader only by this shape.
TEST(ReadDisturbancesTest, TheShapeHasEveryKeyThatIsRead) {
  const DataShape shape = DisturbancesShape(kReadSensors);
  const auto member = [](const DataShape& of, const std::string& key) {
    for (const ShapeMember& one : of.members) {
      if (one.key == key) return true;
    }
    return false;
  };
  int own = 0;
  for (const DisturbanceRule& rule : DisturbanceRules()) {
    if (rule.key.find('.') != std::string::npos) continue;
    EXPECT_TRUE(member(shape, rule.key)) << rule.key;
    ++own;
  }
  EXPECT_EQ(shape.members.size(), static_cast<std::size_t>(own) + 3U) << "and start, sensors and pushes";
  for (const char* group : {"start", "sensors", "pushes"}) EXPECT_TRUE(member(shape, group)) << group;
}

}  // namespace
}  // namespace gaitwright
