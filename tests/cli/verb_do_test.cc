// SPDX-License-Identifier: BSD-3-Clause
// Output and files of `gaitwright do`, and the draft of a robot.yaml.
#include <cstdlib>

#include "tests/cli/stranger.h"
#include "tests/workflows/words/fake_model.h"

namespace gaitwright::cli {
namespace {

using Do = Stranger;

TEST_F(Do, DoesWhatIsSaid) {
  const Ran ran = Run({"do", "squat, then bow", "--robot", "nao", "--yes", "--json"});
  EXPECT_EQ(ran.status, 0) << ran.err;
  const Json json = ran.json();
  EXPECT_EQ(json.at("verdict"), "pass");
  EXPECT_EQ(json.at("understood_by"), "grammar");
  EXPECT_EQ(json.at("tasks").at("tasks").size(), 2U);
  EXPECT_EQ(json.at("tasks").at("tasks")[1].at("action"), "bow");
  EXPECT_EQ(Found(), (std::vector<std::string>{"out"}));
  EXPECT_NE(ran.err.find("1. squat"), std::string::npos);  // the tasks are shown before they are carried out
  const Ran again = Run({"play", "out/plan.json", "--quiet"});
  EXPECT_EQ(again.out, "pass\n");
}

TEST_F(Do, JsonContainsTheNotesOfThePlanner) {
  const Ran ran = Run({"do", "lie down, then walk 0.3 m", "--robot", "a1", "--yes", "--json"});
  ASSERT_EQ(ran.status, 0) << ran.err;
  const Ran shown = Run({"do", "lie down, then walk 0.3 m", "--robot", "a1", "--yes"});
  const Json notes = ran.json().at("notes");
  ASSERT_FALSE(notes.empty());
  EXPECT_NE(shown.out.find("note: " + notes[0].get<std::string>()), std::string::npos) << shown.out;
}

TEST_F(Do, WhatIsNotUnderstoodIsNamedAndNothingWritten) {
  ExpectRefused(Run({"do", "walk two steps and juggle", "--robot", "nao"}), 1, {"'juggle'"});
  ExpectRefused(Run({"do", "wave", "--robot", "a1"}), 1, {"'wave'", "has no arms"});
  ExpectRefused(Run({"do", "squat 40 cm", "--robot", "nao", "--yes", "--quiet"}), 2, {"task 1", "'squat 40 cm'"});
  ExpectRefused(Run({"do"}), 1, {"TEXT", "--task-plan"});
  ExpectRefused(Run({"do", "bow", "--interpreter", "http://localhost:1"}), 1, {"--interpreter", "--model"});
  EXPECT_TRUE(Found().empty());
}

/// Refusals suggest other words, and list the robot's actions only if these are relevant.
TEST_F(Do, RefusalsSayWhatToSayInstead) {
  Write("yard.yaml", "builtin: flat\nmarkers:\n  - {name: red marker, place_m: [1.5, 0.5]}\n");
  const auto refusal = [&](const std::string& text, const std::string& terrain = "flat") {
    const Ran ran = Run({"do", text, "--robot", "nao", "--terrain", terrain, "--yes"});
    EXPECT_NE(ran.status, 0) << text;
    return ran.err;
  };
  const auto says = [&](const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
    EXPECT_EQ(text.find("raise_arm"), std::string::npos) << text;
  };
  says(refusal("turn 90 degrees"), "(try: left or right)");
  says(refusal("walk sideways"), "(try: left or right)");
  says(refusal("walk forward 3"), "(try: a unit: metres");
  says(refusal("nod 1000 times"), "accepted: 1 to 20");
  says(refusal("walk to the kitchen"), "(try: --terrain");
  says(refusal("walk to the kitchen", "./yard.yaml"), "'red marker'");
  says(refusal("jump high"), "'jump forward 30 cm'");
  EXPECT_NE(refusal("do a backflip").find("no gait in which its body turns over"), std::string::npos);
  says(refusal("recover from a push"), "--controller recovering");
  says(refusal("walk at 3 m/s"), "m/s' or slower");
  says(refusal("climb the stairs"), "(try: --terrain stairs");
  says(refusal("go down the stairs", "stairs"), "'climb the stairs, then go down'");
  EXPECT_NE(refusal("juggle").find("raise_arm"), std::string::npos);
}

/// Tasks from a language model are shown, and carried out only with --yes; the key comes from the environment.
TEST_F(Do, ALanguageModelIsAskedAndNothingDoneUnseen) {
  const FakeModel model({{FakeAnswer::Kind::kContent, R"({"schema": 1, "tasks": [{"action": "nod", "times": 2}]})"}});
  const std::vector<std::string> asked = {"do",        "say yes twice", "--robot", "nao",    "--interpreter",
                                          model.url(), "--model",       "m",       "--quiet"};
  ::setenv("GAITWRIGHT_API_KEY", "of-the-environment", 1);
  const Ran unseen = Run(asked);
  ::unsetenv("GAITWRIGHT_API_KEY");
  ExpectRefused(unseen, 1, {"language model", "--yes"});
  EXPECT_TRUE(Found().empty());
  EXPECT_NE(model.requests().at(0).find("Authorization: Bearer of-the-environment"), std::string::npos);
  std::vector<std::string> agreed = asked;
  agreed.back() = "--json";
  agreed.emplace_back("--yes");
  const Ran done = Run(agreed);
  EXPECT_EQ(done.status, 0) << done.err;
  EXPECT_EQ(done.json().at("understood_by"), "language model");
  EXPECT_NE(done.err.find("1. nod"), std::string::npos) << done.err;
}

/// On a terminal the task plan is shown and must be confirmed, also with --quiet.
TEST_F(Do, OnATerminalItIsShownAndAsked) {
  const auto answered = [&](const std::string& answer) {
    const std::string command = ProgramPath() + " do nod --robot nao --quiet";
    return RunWords({"/bin/sh", "-c", "echo " + answer + " | script -qec '" + command + "' /dev/null"});
  };
  const Ran refused = answered("n");
  EXPECT_EQ(refused.status, 1) << refused.out;
  EXPECT_LT(refused.out.find("1. nod"), refused.out.find("Do this?")) << refused.out;
  EXPECT_TRUE(Found().empty());
  const Ran done = answered("y");
  EXPECT_EQ(done.status, 0) << done.out;
  EXPECT_EQ(Found(), std::vector<std::string>{"out"});
}

TEST_F(Do, TaskPlansGoOutAndIn) {
  const Ran tasks = Run({"do", "nod twice", "--robot", "nao", "--tasks-only"});
  EXPECT_EQ(tasks.status, 0);
  EXPECT_EQ(tasks.json().at("tasks")[0].at("times"), 2);
  Write("tasks.json", tasks.out);
  const Ran done = Run({"do", "--task-plan", "tasks.json", "--robot", "nao", "--yes", "--quiet"});
  EXPECT_EQ(done.status, 0) << done.err;
  EXPECT_EQ(done.out, "pass\n");
  Write("wrong.json", R"({"schema": 1, "tasks": [{"action": "nod", "times": 1000}]})");
  ExpectRefused(Run({"do", "--task-plan", "wrong.json", "--robot", "nao"}), 1, {"'tasks[0]'", "1 to 20"});
  EXPECT_TRUE(Run({"do", "--schema"}).json().contains("$schema"));
}

TEST_F(Do, ARobotWithoutLegsGetsADraft) {
  Write(
      "my.urdf",
      "<robot name='my'><link name='body'><inertial><mass value='1'/><inertia ixx='1' iyy='1' izz='1' ixy='0' ixz='0' "
      "iyz='0'/></inertial></link><link name='a'><inertial><mass value='1'/><inertia ixx='1' iyy='1' izz='1' ixy='0' "
      "ixz='0' iyz='0'/></inertial></link><link name='b'><inertial><origin xyz='0 0 -0.1'/><mass value='1'/><inertia "
      "ixx='1' iyy='1' izz='1' ixy='0' ixz='0' iyz='0'/></inertial></link><joint name='hip' type='revolute'><parent "
      "link='body'/><child link='a'/><axis xyz='0 1 0'/><limit lower='-1' upper='1' effort='10' velocity='10'/></joint>"
      "<joint name='knee' type='revolute'><origin xyz='0 0 -0.2'/><parent link='a'/><child link='b'/><axis xyz='0 1 "
      "0'/>"
      "<limit lower='-1' upper='1' effort='10' velocity='10'/></joint></robot>");
  const Ran ran = Run({"walk", "--urdf", "my.urdf"});
  EXPECT_EQ(ran.status, 1);
  EXPECT_NE(ran.err.find("robot.draft.yaml"), std::string::npos) << ran.err;
  EXPECT_NE(Read("robot.draft.yaml").find("- {link: 'b'}"), std::string::npos) << Read("robot.draft.yaml");
}

}  // namespace
}  // namespace gaitwright::cli
