// SPDX-License-Identifier: BSD-3-Clause
#include "planning/tasks/task_plan_json.h"

#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "planning/tasks/task_rules.h"

namespace gaitwright {
namespace {

using Json = nlohmann::ordered_json;

Task WalkBy(double distance_m) {
  return {"walk", {{"direction", std::string("forward")}, {"distance_m", distance_m}}, "", {}};
}

Failure RefusalOfPlan(const std::string& text) {
  const Result<TaskPlan> plan = TaskPlanFromJson(text);
  EXPECT_FALSE(plan.ok()) << text;
  return plan.ok() ? Failure{} : plan.failure();
}

TEST(TaskPlanText, LeavesOutWhatIsNotSaid) {
  TaskPlan plan;
  plan.tasks = {WalkBy(1.5)};
  const Json json = Json::parse(TaskPlanJson(plan));
  EXPECT_EQ(json.dump(), R"({"schema":1,"tasks":[{"action":"walk","direction":"forward","distance_m":1.5}]})");
  plan.text = "go";
  plan.language = "en";
  plan.tasks[0].words = "go";
  const Json said = Json::parse(TaskPlanJson(plan));
  EXPECT_EQ(said["text"], "go");
  EXPECT_EQ(said["language"], "en");
  EXPECT_EQ(said["tasks"][0]["words"], "go");
}

TEST(TaskPlanText, KeepsWordsOfAnyLanguage) {
  TaskPlan plan;
  plan.text = "\xe5\x90\x91\xe5\x89\x8d\xe8\xb5\xb0 \"2\" m\n\\";
  plan.language = "zh";
  plan.tasks = {WalkBy(2.0)};
  const Result<TaskPlan> back = TaskPlanFromJson(TaskPlanJson(plan));
  ASSERT_TRUE(back.ok()) << back.failure().message;
  EXPECT_EQ(*back, plan);
}

TEST(TaskPlanText, WhatIsNoUtf8IsReplacedRatherThanThrown) {
  TaskPlan plan;
  plan.text = "go \xff on";
  plan.tasks = {WalkBy(1.0)};
  EXPECT_NE(TaskPlanJson(plan).find("go \xef\xbf\xbd on"), std::string::npos);
}

TEST(TaskPlanText, NumbersComeBackToTheLastBit) {
  for (const double distance : {0.1, 1.0 / 3.0, 12.345678901234567}) {
    TaskPlan plan;
    plan.tasks = {WalkBy(distance)};
    EXPECT_EQ(TaskPlanFromJson(TaskPlanJson(plan))->tasks[0].Number("distance_m", 0.0), distance);
  }
}

TEST(TaskPlanText, APlaceHasItsNumberOnlyWhereItIsOneOfSeveral) {
  TaskPlan plan;
  plan.tasks = {WalkBy(1.0), WalkBy(1.0)};
  for (Task& task : plan.tasks) task.parameters.erase("distance_m");
  plan.tasks[0].parameters["to"] = PlaceName{"door", 0};
  plan.tasks[1].parameters["to"] = PlaceName{"stone", -1};
  const Json json = Json::parse(TaskPlanJson(plan));
  EXPECT_EQ(json["tasks"][0]["to"].dump(), R"({"name":"door"})");
  EXPECT_EQ(json["tasks"][1]["to"].dump(), R"({"name":"stone","number":-1})");
  EXPECT_EQ(TaskPlanFromJson(TaskPlanJson(plan)).value(), plan);
}

TEST(TaskPlanRefusals, AreBadInputWithThePathToTheWrongValue) {
  const std::vector<std::pair<std::string, std::string>> wrong = {
      {R"({"tasks": []})", "lacks 'schema'"},
      {R"({"schema": 1})", "lacks 'tasks'"},
      {R"({"schema": "1", "tasks": []})", "'schema'"},
      {R"({"schema": 1, "tasks": {}})", "'tasks'"},
      {R"({"schema": 1, "tasks": [{}]})", "'tasks[0]' lacks 'action'"},
      {R"({"schema": 1, "tasks": [{"action": "sit"}, {"action": 3}]})", "'tasks[1].action'"},
      {R"({"schema": 1, "tasks": [{"action": "squat", "times": 1.5}]})", "'tasks[0].times'"},
      {R"({"schema": 1, "tasks": [{"action": "squat", "while": [{"action": "nodd"}]}]})", "'tasks[0].while[0]'"},
      {R"({"schema": 1, "tasks": [], "txet": ""})", "'text'"},
      {R"([1])", "an object"}};
  for (const auto& [text, says] : wrong) {
    const Failure failure = RefusalOfPlan(text);
    EXPECT_EQ(failure.kind, FailureKind::kBadInput);
    EXPECT_EQ(failure.code, FailureCode::kTaskPlan);
    EXPECT_NE(failure.message.find(says), std::string::npos) << text << ": " << failure.message;
  }
}

/// The schemas of all tasks by their action.
std::map<std::string, Json> SchemasByAction(const Json& list) {
  std::map<std::string, Json> schemas;
  for (const Json& schema : list) schemas[schema["properties"]["action"]["const"]] = schema;
  return schemas;
}

TEST(TaskPlanSchemaText, HasTheRequiredAndOptionalKeysOfEachAction) {
  const Json whole = Json::parse(TaskPlanSchema());
  const auto schemas = SchemasByAction(whole["properties"]["tasks"]["items"]["oneOf"]);
  EXPECT_EQ(schemas.size(), ActionRules().size());
  for (const ActionRule& rule : ActionRules()) {
    const Json& schema = schemas.at(rule.action);
    EXPECT_EQ(schema["additionalProperties"], false);
    EXPECT_EQ(schema["required"][0], "action") << rule.action;
    EXPECT_EQ(schema["required"].size(), rule.required.size() + 1) << rule.action;
    for (const std::string& key : rule.required) EXPECT_TRUE(schema["properties"].contains(key)) << key;
    for (const std::string& key : rule.optional) EXPECT_TRUE(schema["properties"].contains(key)) << key;
    EXPECT_NE(schema["properties"].contains("while"), rule.is_gesture) << "a gesture has none beside it";
  }
}

TEST(TaskPlanSchemaText, GesturesAreThoseThatMayBeMadeMeanwhile) {
  const Json whole = Json::parse(TaskPlanSchema());
  const auto gestures = SchemasByAction(whole["$defs"]["gesture"]["oneOf"]);
  for (const ActionRule& rule : ActionRules()) EXPECT_EQ(gestures.contains(rule.action), rule.is_gesture);
  const Json one = Json::parse(TaskPlanSchema({"squat"}));
  EXPECT_EQ(one["properties"]["tasks"]["items"]["oneOf"].size(), 1U);
}

TEST(TaskTextOfTask, ReadsAsPeopleSayIt) {
  EXPECT_EQ(TaskText(WalkBy(2.0)), "walk forward, 2 m");
  EXPECT_EQ(TaskText({"raise_arm", {{"side", std::string("left")}}, "", {}}), "raise arm left");
  EXPECT_EQ(TaskText({"squat", {{"times", 1}}, "", {}}), "squat, 1 time");
  EXPECT_EQ(TaskText({"squat", {{"times", 3}}, "", {}}), "squat, 3 times");
  Task walk{"walk", {{"direction", std::string("forward")}, {"to", PlaceName{"stone", 2}}}, "", {}};
  EXPECT_EQ(TaskText(walk), "walk forward, to stone 2");
  walk.parameters["to"] = PlaceName{"stone", -1};
  walk.during = {{"nod", {}, "", {}}, {"wave", {}, "", {}}};
  EXPECT_EQ(TaskText(walk), "walk forward, to the last stone; meanwhile nod and wave");
}

}  // namespace
}  // namespace gaitwright
