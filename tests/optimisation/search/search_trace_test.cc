// SPDX-License-Identifier: BSD-3-Clause
// The trace of a search holds every plan that was tried, and recording it changes nothing.
#include "optimisation/search/search_trace.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <variant>

#include "kinematics/model/load_robot.h"
#include "optimisation/search/plan_walk.h"
#include "planning/plan/plan_json.h"

namespace gaitwright {
namespace {

TEST(SearchTrace, OfAWalkThatPassesAtOnceHasOneSoundPlan) {
  const RobotModel a1 = LoadNamedRobot("a1").value();
  WalkRequest request;
  request.command.distance_m = 0.5;
  request.command.speed_m_s = 0.3;
  SearchTrace trace;
  const Result<PlannedWalk> planned = PlanWalk(a1, request, &trace);
  ASSERT_TRUE(planned.ok()) << planned.failure().message;
  ASSERT_EQ(trace.size(), 1U);
  EXPECT_EQ(trace.front().effort, Effort::kWhole);
  EXPECT_EQ(trace.front().pace, "speed");
  EXPECT_EQ(trace.front().pace_value, 0.3);
  EXPECT_EQ(trace.front().unit, "m/s");
  EXPECT_EQ(trace.front().cycle_s, planned->motion.plan.parts.front().gait.cycle_s);
  EXPECT_EQ(trace.front().refused, std::nullopt);
  EXPECT_EQ(PlanToJson(PlanWalk(a1, request)->motion.plan), PlanToJson(planned->motion.plan));
}

TEST(SearchTrace, OfARefusedWalkEndsWithWhatMadeTheSuggestion) {
  const RobotModel nao = LoadNamedRobot("nao").value();
  WalkRequest request;
  request.command.distance_m = 0.3;
  request.command.speed_m_s = 1.0;
  SearchTrace trace;
  const Result<PlannedWalk> planned = PlanWalk(nao, request, &trace);
  ASSERT_FALSE(planned.ok());
  ASSERT_GT(trace.size(), 1U);
  EXPECT_EQ(trace.front().pace_value, 1.0);
  EXPECT_EQ(trace.front().refused, planned.failure().code);
  ASSERT_FALSE(planned.failure().suggestions.empty());
  const double suggested = std::get<double>(planned.failure().suggestions.front().value);
  EXPECT_TRUE(std::any_of(trace.begin(), trace.end(), [&](const TriedPlan& tried) {
    return tried.pace_value == suggested && !tried.refused;
  })) << "the slower walk that is suggested was planned";
}

TEST(SearchTrace, TheTextHasALineForEachPlan) {
  const std::string text = TraceText({{Effort::kStart, "speed", 0.5, "m/s", 0.4, FailureCode::kLimits},
                                      {Effort::kWhole, "speed", 0.4, "m/s", 0.4, std::nullopt}});
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 3);
  EXPECT_EQ(text.find("free footholds"), std::string::npos);
  EXPECT_NE(TraceText({{Effort::kWhole, "speed", 0.4, "m/s", 0.4, std::nullopt, true}}).find("free footholds"),
            std::string::npos);
  EXPECT_NE(text.find("limits"), std::string::npos) << text;
  EXPECT_NE(text.find("sound"), std::string::npos) << text;
}

}  // namespace
}  // namespace gaitwright
