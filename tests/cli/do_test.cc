// SPDX-License-Identifier: BSD-3-Clause
// What `gaitwright do` says and writes, and the draft of a robot.yaml.
#include "tests/cli/stranger.h"

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
  EXPECT_NE(ran.err.find("1. squat"), std::string::npos);  // it is shown before it is done
  const Ran again = Run({"play", "out/plan.json", "--quiet"});
  EXPECT_EQ(again.out, "pass\n");
}

TEST_F(Do, WhatIsNotUnderstoodIsNamedAndNothingWritten) {
  ExpectRefused(Run({"do", "walk two steps and juggle", "--robot", "nao"}), 1, {"'juggle'"});
  ExpectRefused(Run({"do", "wave", "--robot", "a1"}), 1, {"'wave'", "has no arms"});
  ExpectRefused(Run({"do", "squat 40 cm", "--robot", "nao", "--yes", "--quiet"}), 2, {"task 1", "'squat 40 cm'"});
  ExpectRefused(Run({"do"}), 1, {"TEXT", "--task-plan"});
  ExpectRefused(Run({"do", "bow", "--interpreter", "http://localhost:1"}), 1, {"--interpreter", "--model"});
  EXPECT_TRUE(Found().empty());
}

/// What to say instead, in words, and what the robot can do only where that is the question.
TEST_F(Do, RefusalsSayWhatToSayInstead) {
  Write("yard.yaml", "builtin: flat\nmarkers:\n  - {name: red marker, place_m: [1.5, 0.5]}\n");
  const auto refusal = [&](const std::string& text, const std::string& terrain = "flat") {
    const Ran ran = Run({"do", text, "--robot", "nao", "--terrain", terrain, "--yes"});
    EXPECT_NE(ran.status, 0) << text;
    return ran.err;
  };
  const auto says = [&](const std::string& told, const std::string& part) {
    EXPECT_NE(told.find(part), std::string::npos) << told;
    EXPECT_EQ(told.find("raise_arm"), std::string::npos) << told;
  };
  says(refusal("turn 90 degrees"), "(try: left or right)");
  says(refusal("walk sideways"), "(try: left or right)");
  says(refusal("walk forward 3"), "(try: its unit: metres");
  says(refusal("nod 1000 times"), "1 to 20 is accepted");
  says(refusal("walk to the kitchen"), "(try: --terrain");
  says(refusal("walk to the kitchen", "./yard.yaml"), "'red marker'");
  says(refusal("recover from a push"), "--controller recovering");
  says(refusal("walk at 3 m/s"), "(try: 'at 0.");
  EXPECT_NE(refusal("juggle").find("raise_arm"), std::string::npos);
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
