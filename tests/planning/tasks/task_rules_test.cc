// SPDX-License-Identifier: BSD-3-Clause
#include "planning/tasks/task_rules.h"

#include <gtest/gtest.h>

#include "kinematics/model/load_robot.h"
#include "planning/tasks/task_plan_json.h"

namespace gaitwright {
namespace {

Task Walk() { return {"walk", {{"direction", std::string("forward")}, {"distance_m", 1.0}}, "", {}}; }

std::string ReasonNone(const Task& task) {
  const auto failure = ReasonNoTask(task);
  return failure ? FailureCodeName(failure->code) + ": " + failure->message : "";
}

TEST(TaskRules, EachActionHasItsParameters) {
  for (const ActionRule& rule : ActionRules()) {
    for (const auto* keys : {&rule.required, &rule.optional}) {
      for (const std::string& key : *keys) EXPECT_NE(FindParameter(key), nullptr) << rule.action << ' ' << key;
    }
    if (!rule.instead.empty()) {
      EXPECT_NE(FindAction(rule.instead), nullptr) << rule.action;
    }
  }
}

TEST(TaskRules, WhatIsNoTaskIsRefusedWithItsReason) {
  EXPECT_EQ(ReasonNone(Walk()), "");
  const auto refused = [](auto change, const std::string& words) {
    Task task = Walk();
    change(task);
    EXPECT_NE(ReasonNone(task).find(words), std::string::npos) << ReasonNone(task);
  };
  refused([](Task& t) { t.action = "wlak"; }, "there is no action 'wlak'; the nearest is 'walk'");
  refused([](Task& t) { t.parameters.erase("direction"); }, "lacks its parameter 'direction'");
  refused([](Task& t) { t.parameters["depth_m"] = 0.1; }, "has no parameter 'depth_m'");
  refused([](Task& t) { t.parameters["distance_m"] = 5000.0; },
          "range: 'distance_m' of 'walk' is 5000; accepted: 0.01 to 50");
  refused([](Task& t) { t.parameters["distance_m"] = std::nan(""); }, "range");
  refused([](Task& t) { t.parameters["distance_m"] = 2; }, "must be a number");
  refused([](Task& t) { t.parameters["direction"] = std::string("up"); }, "accepted: 'forward'");
  refused([](Task& t) { t.parameters["steps"] = 3; }, "each set the distance");
  refused([](Task& t) { t.parameters["step_length_m"] = 0.1; }, "is for use with 'steps'");
  refused([](Task& t) { t.during = {Walk()}; }, "'walk' cannot run at the same time as 'walk'");
  Task bow{"bow", {{"angle_deg", 90.0}}, "", {}};
  EXPECT_NE(ReasonNone(bow).find("1 to 60"), std::string::npos) << ReasonNone(bow);
}

TEST(TaskRules, TasksThatTheRobotCannotDoAreNamed) {
  const TaskScope a1 = ScopeOf(LoadNamedRobot("a1").value()), nao = ScopeOf(LoadNamedRobot("nao").value());
  const Task wave{"wave", {{"side", std::string("right")}}, "", {}}, lie{"lie_down", {}, "", {}};
  EXPECT_FALSE(ReasonNotDone(wave, nao));
  EXPECT_FALSE(ReasonNotDone(lie, a1));
  const auto no_arms = ReasonNotDone(wave, a1);
  ASSERT_TRUE(no_arms);
  EXPECT_EQ(no_arms->message, "robot 'a1' cannot 'wave': it has no arms");
  EXPECT_EQ(no_arms->suggestions.front().text, "the closest action that it can do is nod");
  const auto no_four = ReasonNotDone(lie, nao);
  ASSERT_TRUE(no_four);
  EXPECT_EQ(no_four->code, FailureCode::kCannot);
}

TEST(TaskRules, AJumpGoesToOnePlaceAtMost) {
  const auto why = [](std::map<std::string, TaskValue> parameters) {
    return ReasonNone({"jump", std::move(parameters), "", {}});
  };
  const TaskValue left = std::string("left"), down = std::string("down"), block = PlaceName{"block", 0};
  EXPECT_EQ(why({}), "");
  EXPECT_EQ(why({{"turn", left}, {"angle_deg", 90.0}, {"distance_m", 0.3}}), "");
  EXPECT_EQ(why({{"to", block}, {"turn", left}}), "");
  EXPECT_NE(why({{"to", block}, {"distance_m", 0.3}}).find("each set where to jump"), std::string::npos);
  EXPECT_NE(why({{"level", down}, {"distance_m", 0.3}}).find("each set where to jump"), std::string::npos);
  EXPECT_NE(why({{"to", block}, {"times", 2}}).find("is done once"), std::string::npos);
  EXPECT_NE(why({{"angle_deg", 90.0}}).find("for use with 'turn'"), std::string::npos);
  EXPECT_NE(why({{"turn", left}, {"angle_deg", 200.0}}).find("1 to 180"), std::string::npos);
}

/// What a robot can do is what its number of feet has gaits for.
TEST(TaskRules, FlipsAreThoseOfTheGaits) {
  const TaskScope a1 = ScopeOf(LoadNamedRobot("a1").value()), nao = ScopeOf(LoadNamedRobot("nao").value());
  const auto flip = [](const char* direction) { return Task{"flip", {{"direction", std::string(direction)}}, "", {}}; };
  EXPECT_TRUE(a1.leaps && nao.leaps);
  EXPECT_FALSE(ReasonNotDone(flip("backward"), a1));
  EXPECT_FALSE(ReasonNotDone(flip("right"), a1));
  const auto forward = ReasonNotDone(flip("forward"), a1), biped = ReasonNotDone(flip("backward"), nao);
  ASSERT_TRUE(forward && biped);
  EXPECT_NE(forward->message.find("turns over forward; it has gaits for 'backward'"), std::string::npos)
      << forward->message;
  EXPECT_EQ(biped->message, "robot 'nao' cannot 'flip': it has no gait in which its body turns over");
}

TEST(TaskRules, PlacesAreThoseThatThereAre) {
  TaskScope scope = ScopeOf(LoadNamedRobot("nao").value());
  scope.places = {{"door", 0}, {"stone", 3}};
  const auto to = [&](const std::string& name, int number) {
    const Task task{"walk", {{"direction", std::string("forward")}, {"to", PlaceName{name, number}}}, "", {}};
    const auto failure = ReasonNotDone(task, scope);
    return failure ? failure->message : "";
  };
  EXPECT_EQ(to("door", 0), "");
  EXPECT_EQ(to("stone", 3), "");
  EXPECT_EQ(to("stone", -1), "");
  EXPECT_NE(to("stone", 4).find("a number from 1 to 3"), std::string::npos);
  EXPECT_NE(to("stone", 0).find("a number from 1 to 3"), std::string::npos);
  EXPECT_NE(to("stonne", 1).find("the nearest is 'stone'"), std::string::npos);
}

TEST(TaskPlanJson, RoundTrips) {
  TaskPlan plan;
  plan.text = "walk to the second stone while waving, then squat twice";
  plan.language = "en";
  Task walk{"walk", {{"direction", std::string("forward")}, {"to", PlaceName{"stone", 2}}}, "walk to it", {}};
  walk.during = {{"wave", {{"side", std::string("both")}, {"duration_s", 2.5}}, "waving", {}}};
  plan.tasks = {walk, {"squat", {{"times", 2}, {"depth_m", 0.05}}, "squat twice", {}}};
  const Result<TaskPlan> read = TaskPlanFromJson(TaskPlanJson(plan));
  ASSERT_TRUE(read.ok()) << read.failure().message;
  EXPECT_EQ(*read, plan);
}

TEST(TaskPlanJson, WhatIsWrongIsNamed) {
  const auto why = [](const std::string& text) {
    const Result<TaskPlan> read = TaskPlanFromJson(text);
    return read ? std::string() : read.failure().message;
  };
  EXPECT_EQ(why(R"({"schema": 1, "tasks": [{"action": "sit"}]})"), "");
  EXPECT_NE(why(R"({"schema": 1, "tasks": [{"action": "sit"})"), "");
  EXPECT_NE(why(R"({"schema": 2, "tasks": []})").find("'schema'"), std::string::npos);
  EXPECT_NE(why(R"({"schema": 1, "tasks": [{"action": "sit", "wile": []}]})").find("the nearest is 'while'"),
            std::string::npos);
  EXPECT_NE(why(R"({"schema": 1, "tasks": [{"action": "walk", "direction": "forward", "distance_m": 1e9}]})")
                .find("'tasks[0]'"),
            std::string::npos);
  EXPECT_NE(why(R"({"schema": 1, "tasks": [{"action": "sit", "action": "walk"}]})"), "");
  EXPECT_NE(why("sit"), "");
}

/// The schema names each known action and parameter, and only the requested actions.
TEST(TaskPlanJson, TheSchemaIsThatOfTheRules) {
  const std::string schema = TaskPlanSchema();
  for (const ActionRule& rule : ActionRules())
    EXPECT_NE(schema.find("\"const\": \"" + rule.action + "\""), std::string::npos) << rule.action;
  for (const ParameterRule& rule : ParameterRules())
    EXPECT_NE(schema.find("\"" + rule.key + "\""), std::string::npos) << rule.key;
  EXPECT_EQ(TaskPlanSchema({"sit"}).find("\"const\": \"walk\""), std::string::npos);
}

}  // namespace
}  // namespace gaitwright
