// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "workflows/grade/rubric.h"

namespace gaitwright {
namespace {

const std::string kHead = "title: t\nparts:\n";
const std::string kZmpRubric = "- {name: zmp, kind: function, file: z.py, points: 5, reference: pendulum_zmp";
const std::string kTrotRubric =
    "- {name: trot, kind: parameters, file: t.yaml, points: 5, robot: a1, command: {speed_m_s: 0.3, distance_m: 1}";
const std::string kPass = ", checks: [{measure: pass, points: 5}]";

void ExpectRefused(const std::string& text, const std::vector<std::string>& words) {
  const Result<Rubric> rubric = ReadRubric(text, "r.yaml");
  ASSERT_FALSE(rubric.ok()) << text;
  EXPECT_EQ(rubric.failure().code, FailureCode::kRubric);
  for (const std::string& word : words)
    EXPECT_NE(rubric.failure().message.find(word), std::string::npos) << rubric.failure().message;
}

TEST(ReadRubric, ReadsPartsOfEachSort) {
  const Result<Rubric> rubric = ReadRubric(
      kHead + kZmpRubric + ", limits: {time_s: 2, memory_mb: 256}, inputs: {com_height_m: [0.2, 0.3]}}\n" +
          kTrotRubric +
          ", runs: 3, trials: 4, options: [gait.cycle_s, swing.*], play: {play.friction: [0.5, 0.9], state: estimated}"
          ", checks: [{measure: pass, points: 3, none_at: 0}, {measure: goal_error_m, points: 2, full_at: 0.05, "
          "none_at: 0.2}]}\n",
      "r.yaml");
  ASSERT_TRUE(rubric.ok()) << rubric.failure().message;
  EXPECT_EQ(rubric->points(), 10.0);
  const RubricPart& zmp = rubric->parts[0];
  EXPECT_EQ(zmp.function, "pendulum_zmp");
  EXPECT_EQ(zmp.limits.time_s, 2.0);
  EXPECT_EQ(zmp.limits.memory_mb, 256);
  EXPECT_FALSE(zmp.package);
  EXPECT_EQ(zmp.checks.front().measure, "share_right");
  EXPECT_EQ(zmp.question.inputs.front().second, (NumberRange{0.2, 0.3}));
  const RubricPart& trot = rubric->parts[1];
  EXPECT_EQ(trot.motion.runs, 3);
  EXPECT_EQ(trot.motion.play_numbers.front().second, (NumberRange{0.5, 0.9}));
  EXPECT_EQ(trot.motion.play_words.front().second, "estimated");
  EXPECT_FALSE(trot.checks[1].higher_is_better);
}

TEST(ReadRubric, ChecksGivePointsInProportion) {
  const Check share{"share_right", 8.0, 1.0, 0.5, true};
  EXPECT_EQ(share.PointsOf(1.0), 8.0);
  EXPECT_EQ(share.PointsOf(0.75), 4.0);
  EXPECT_EQ(share.PointsOf(0.5), 0.0);
  EXPECT_EQ(share.PointsOf(0.1), 0.0);
  const Check error{"largest_error", 8.0, 0.1, 0.5, false};
  EXPECT_EQ(error.PointsOf(0.0), 8.0);
  EXPECT_NEAR(error.PointsOf(0.3), 4.0, 1e-12);
  EXPECT_EQ(error.PointsOf(1e9), 0.0);
  const Check all{"pass", 8.0, 1.0, {}, true};
  EXPECT_EQ(all.PointsOf(0.99), 0.0);
}

TEST(ReadRubric, RefusesUnknownKeysWithTheNearest) {
  ExpectRefused("titel: t\nparts: []\n", {"'r.yaml', line 1", "'titel'", "'title'"});
  ExpectRefused(kHead + kZmpRubric + ", tolerence: 1}\n", {"line 3", "'tolerence'", "'tolerance'"});
  ExpectRefused(kHead + kZmpRubric + ", robots: a1}\n", {"'robots'", "'robot'"});
  ExpectRefused(kHead + kZmpRubric + ", limits: {times_s: 1}}\n", {"'times_s'", "'time_s'"});
  ExpectRefused(kHead + kZmpRubric + ", inputs: {com_hight_m: 1}}\n", {"'com_hight_m'", "'com_height_m'"});
  ExpectRefused(kHead + kZmpRubric + ", controller: stabilised}\n", {"'controller'"});
  ExpectRefused(kHead + kTrotRubric + kPass + ", speed: 1}\n", {"'speed'"});
  ExpectRefused(kHead + "- {name: p, kind: functoin, file: f, points: 1}\n", {"'functoin'", "'function'"});
}

TEST(ReadRubric, RefusesWhatThereIsNot) {
  ExpectRefused(kHead + "- {name: p, kind: function, file: f, points: 1, reference: zmp_pendulum}\n",
                {"no reference 'zmp_pendulum'"});
  ExpectRefused(kHead + "- {name: p, kind: function, file: f, points: 1, reference: leg_ik}\n",
                {"lacks the key 'robot'"});
  ExpectRefused(kHead + kTrotRubric + ", checks: [{measure: goal_eror_m, points: 5}]}\n",
                {"'goal_eror_m'", "'goal_error_m'"});
  ExpectRefused(kHead + kTrotRubric + ", checks: [{measure: goal_error_m, points: 5}]}\n", {"lacks 'full_at'"});
  ExpectRefused(kHead + kTrotRubric + "}\n", {"lacks the key 'checks'"});
  ExpectRefused(kHead + kTrotRubric + kPass + ", options: [gait.cicle_s]}\n", {"'gait.cicle_s'", "'gait.cycle_s'"});
  ExpectRefused(kHead + kTrotRubric + kPass + ", play: {play.frction: 1}}\n", {"'play.frction'", "'play.friction'"});
  ExpectRefused(kHead + kTrotRubric + kPass + ", controller: stabilized}\n", {"'stabilized'", "'stabilised'"});
  ExpectRefused(kHead + kTrotRubric + kPass + ", gait: troot}\n", {"'troot'", "'trot'"});
  ExpectRefused(kHead + kTrotRubric + kPass + ", disturbances: none}\n", {"'none'", "'standard'"});
  ExpectRefused(kHead + kTrotRubric + kPass + ", terrain: my.yaml}\n", {"'my.yaml' is a file"});
  ExpectRefused(kHead + "- {name: p, kind: planner, file: f, points: 1, robot: noa" + kPass + "}\n",
                {"no robot 'noa'", "'nao'"});
}

TEST(ReadRubric, RefusesValuesOutOfRange) {
  ExpectRefused(kHead + kZmpRubric + ", cases: 0}\n", {"'cases' is 0", "1 to 10000"});
  ExpectRefused(kHead + kZmpRubric + ", cases: 2.5}\n", {"'cases' is 2.5", "whole"});
  ExpectRefused(kHead + kZmpRubric + ", limits: {memory_mb: 1}}\n", {"'memory_mb'", "1"});
  ExpectRefused(kHead + kZmpRubric + ", inputs: {com_height_m: [2, 1]}}\n",
                {"from 2 to 1", "must be below the second"});
  ExpectRefused(kHead + kZmpRubric + ", inputs: {com_height_m: [2]}}\n", {"has 1 numbers"});
  ExpectRefused(kHead + kZmpRubric + ", checks: [{measure: share_right, points: 4}]}\n",
                {"4 points in all, but the part has 5"});
  ExpectRefused(kHead + kZmpRubric + ", checks: [{measure: share_right, points: 5, full_at: 1, none_at: 1}]}\n",
                {"both 1"});
  ExpectRefused(kHead + "- {name: 1p, kind: function, file: f, points: 1, reference: dcm}\n", {"'1p'", "letter"});
  ExpectRefused(kHead + "- {name: p, kind: function, file: ../f, points: 1, reference: dcm}\n",
                {"'../f'", "without folders"});
  ExpectRefused(kHead + "- {name: p, kind: function, file: f, points: 0, reference: dcm}\n",
                {"'points' is 0", "above 0"});
  ExpectRefused(kHead + kZmpRubric + "}\n" + kZmpRubric + "}\n", {"two parts are named 'zmp'"});
  ExpectRefused(kHead + "- {name: p, kind: planner, file: f, points: 5, robot: nao" + kPass + "}\n", {"lacks a goal"});
  ExpectRefused("title: t\nparts: []\n", {"0 parts"});
  ExpectRefused("just words\n", {"no rubric"});
  ExpectRefused("a: [\n", {"not valid YAML"});
}

}  // namespace
}  // namespace gaitwright
