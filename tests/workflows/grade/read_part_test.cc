// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include "workflows/grade/read_part_internal.h"
#include "workflows/grade/rubric_shape.h"
#include "workflows/walk/walk.h"

namespace gaitwright {
namespace {

template <class Call>
std::string RefusalOfYaml(Call call) {
  try {
    call();
  } catch (const InvalidArgument& error) {
    return error.what();
  }
  return "nothing was refused";
}

void ExpectWords(const std::string& text, const std::vector<std::string>& words) {
  for (const std::string& word : words) EXPECT_NE(text.find(word), std::string::npos) << word << " in: " << text;
}

/// The YAML of a part, completed with the required keys of its kind.
std::string WholePart(const std::string& yaml, RubricPartKind kind) {
  std::string keys = "{name: p, kind: " + PartKindNames()[static_cast<std::size_t>(kind)] + ", file: f, points: 1";
  if (PlaysMotions(kind)) keys += ", checks: []";
  const std::string needed = PlaysMotions(kind) ? "robot" : "reference";
  if (yaml.find(needed + ":") == std::string::npos) keys += ", " + needed + (PlaysMotions(kind) ? ": nao" : ": dcm");
  return keys + (yaml == "{}" ? "" : ", ") + yaml.substr(1);
}

RubricPart MotionPartOf(const std::string& yaml, RubricPartKind kind = RubricPartKind::kParameters) {
  RubricPart part;
  part.name = "p";
  part.kind = kind;
  const YAML::Node node = YAML::Load(WholePart(yaml, kind));
  const DataShape shape = PartShape(kind);
  ReadMotionSetup(YamlMap(node, "a part", shape), node, part);
  return part;
}

TEST(ReadPart, ANumberIsARangeOfNoWidth) {
  EXPECT_EQ(RangeAt(YAML::Load("0.5"), "'x'"), (NumberRange{0.5, 0.5}));
  EXPECT_EQ(RangeAt(YAML::Load("[-1, 2.5]"), "'x'"), (NumberRange{-1.0, 2.5}));
  EXPECT_EQ(RangeAt(YAML::Load("[2, 2]"), "'x'"), (NumberRange{2.0, 2.0}));
  ExpectWords(RefusalOfYaml([] { RangeAt(YAML::Load("[2, 1]"), "'x'"); }), {"'x'", "from 2 to 1"});
  ExpectWords(RefusalOfYaml([] { RangeAt(YAML::Load("[1, 2, 3]"), "'x'"); }), {"'x'", "3 numbers"});
  ExpectWords(RefusalOfYaml([] { RangeAt(YAML::Load("fast"), "'x'"); }), {"'x'", "fast"});
}

TEST(ReadPart, AMeasureIsOneOfItsKindAndKnowsWhichDirectionIsBetter) {
  const YAML::Node node = YAML::Load("measure");
  const MeasureRule share = MeasureAt(node, "share_right", RubricPartKind::kFunction),
                    error = MeasureAt(node, "largest_error", RubricPartKind::kFunction);
  EXPECT_TRUE(share.higher_is_better);
  EXPECT_EQ(share.usual_full_at, 1.0);
  EXPECT_FALSE(error.higher_is_better);
  EXPECT_FALSE(error.usual_full_at) << "the rubric says it";
  ExpectWords(RefusalOfYaml([&] { MeasureAt(node, "share_right", RubricPartKind::kPlan); }), {"'share_right'"});
  ExpectWords(RefusalOfYaml([&] { MeasureAt(node, "goal_error_m", RubricPartKind::kAnswers); }), {"'goal_error_m'"});
  ExpectWords(RefusalOfYaml([&] { MeasureAt(node, "larges_error", RubricPartKind::kAnswers); }), {"'largest_error'"});
}

TEST(ReadPart, AMotionHasWhatIsSaidAndElseItsDefaults) {
  const MotionSetup usual = MotionPartOf("{robot: nao}").motion;
  EXPECT_EQ(usual.terrain, "flat");
  EXPECT_EQ(usual.runs, 1);
  EXPECT_EQ(usual.controller, "stabilised");
  EXPECT_FALSE(usual.disturbances);
  const MotionSetup said =
      MotionPartOf(
          "{robot: a1, gait: trot, terrain: {name: stairs, rise_m: [0.05, 0.1]}, runs: 3, trials: 2, "
          "command: {speed_m_s: [0.2, 0.4], distance_m: 1}, play: {play.friction: [0.5, 0.9]}}")
          .motion;
  EXPECT_EQ(said.robot, "a1");
  EXPECT_EQ(said.gait, "trot");
  EXPECT_EQ(said.terrain, "stairs");
  ASSERT_EQ(said.terrain_parameters.size(), 1U);
  EXPECT_EQ(said.terrain_parameters[0].second, (NumberRange{0.05, 0.1}));
  EXPECT_EQ(said.runs, 3);
  EXPECT_EQ(said.trials, 2);
  EXPECT_EQ(said.command.size(), 2U);
  ASSERT_EQ(said.play_numbers.size(), 1U);
  EXPECT_EQ(said.play_numbers[0].first, "play.friction");
}

TEST(ReadPart, BothEndsOfARangeOfThePlaybackAreChecked) {
  ExpectWords(RefusalOfYaml([] { MotionPartOf("{robot: a1, play: {play.friction: [0.5, 1000]}}"); }),
              {"line 1", "play.friction", "1000"});
  ExpectWords(RefusalOfYaml([] { MotionPartOf("{robot: a1, play: {play.friction: [-1, 0.5]}}"); }),
              {"play.friction", "-1"});
}

TEST(ReadPart, APlannerIsMarkedByItsGoalAlone) {
  const std::string goal = "{robot: nao, command: {goal_x_m: 1, goal_yaw_rad: [0, 0.5]}}";
  EXPECT_EQ(MotionPartOf(goal, RubricPartKind::kPlanner).motion.command.size(), 2U);
  ExpectWords(RefusalOfYaml([] { MotionPartOf("{robot: nao}", RubricPartKind::kPlanner); }), {"'p'", "goal_x_m"});
  ExpectWords(RefusalOfYaml([] { MotionPartOf("{robot: nao, command: {distance_m: 1}}", RubricPartKind::kMotion); }),
              {"goal_x_m"});
  EXPECT_NO_THROW(MotionPartOf("{robot: nao}", RubricPartKind::kMotion));
}

TEST(ReadPart, FilesAreNoGroundsOfARubric) {
  ExpectWords(RefusalOfYaml([] { MotionPartOf("{robot: nao, terrain: ./mine.yaml}"); }), {"./mine.yaml"});
  ExpectWords(RefusalOfYaml([] { MotionPartOf("{robot: nao, terrain: {name: ./mine.yaml}}"); }), {"./mine.yaml"});
}

TEST(ReadPart, OptionsMayEndInAStarAndMustBePlanOptions) {
  EXPECT_EQ(MotionPartOf("{robot: a1, options: [gait.cycle_s, 'swing.*']}").motion.options,
            (std::vector<std::string>{"gait.cycle_s", "swing.*"}));
  ExpectWords(RefusalOfYaml([] { MotionPartOf("{robot: a1, options: [swim.*]}"); }), {"'swim.*'"});
}

RubricPart QuestionPartOf(const std::string& yaml, RubricPartKind kind) {
  RubricPart part;
  part.name = "p";
  part.kind = kind;
  const YAML::Node node = YAML::Load(WholePart(yaml, kind));
  const DataShape shape = PartShape(kind);
  ReadQuestionSetup(YamlMap(node, "a part", shape), node, part);
  return part;
}

TEST(ReadPart, ASeedIsOfAnswersAloneAndAReferenceMayNeedARobot) {
  EXPECT_EQ(QuestionPartOf("{reference: dcm, seed: 3}", RubricPartKind::kAnswers).question.seed, 3U);
  EXPECT_FALSE(QuestionPartOf("{reference: dcm}", RubricPartKind::kAnswers).question.seed);
  EXPECT_EQ(QuestionPartOf("{reference: leg_fk, robot: nao}", RubricPartKind::kFunction).question.robot, "nao");
  ExpectWords(RefusalOfYaml([] { QuestionPartOf("{reference: leg_fk}", RubricPartKind::kFunction); }),
              {"'p'", "'leg_fk'"});
  ExpectWords(RefusalOfYaml([] { QuestionPartOf("{reference: dcn}", RubricPartKind::kFunction); }), {"'dcn'", "'dcm'"});
}

TEST(ReadPart, CodeHasTheFunctionOfItsKindUnlessAnotherIsNamed) {
  const auto function_of = [](const std::string& yaml, RubricPartKind kind) {
    RubricPart part;
    part.kind = kind;
    part.question.reference = "dcm";
    const YAML::Node node = YAML::Load(WholePart(yaml, kind));
    const DataShape shape = PartShape(kind);
    ReadCodeSetup(YamlMap(node, "a part", shape), part);
    return part;
  };
  EXPECT_EQ(function_of("{}", RubricPartKind::kFunction).function, "dcm");
  EXPECT_EQ(function_of("{}", RubricPartKind::kPlanner).function, "plan_steps");
  EXPECT_EQ(function_of("{}", RubricPartKind::kController).function, "make_controller");
  EXPECT_EQ(function_of("{function: mine}", RubricPartKind::kPlanner).function, "mine");
  EXPECT_FALSE(function_of("{}", RubricPartKind::kFunction).package);
  EXPECT_TRUE(function_of("{}", RubricPartKind::kController).package);
  EXPECT_TRUE(function_of("{package: true}", RubricPartKind::kFunction).package);
  ExpectWords(RefusalOfYaml([&] { function_of("{package: perhaps}", RubricPartKind::kFunction); }), {"'perhaps'"});
}

}  // namespace
}  // namespace gaitwright
