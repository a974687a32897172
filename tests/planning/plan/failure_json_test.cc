// SPDX-License-Identifier: BSD-3-Clause
#include "planning/plan/failure_json.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace gaitwright {
namespace {

using Json = nlohmann::ordered_json;

TEST(FailureJson, HasTheFailuresFiguresAndWhatWouldHelp) {
  Failure failure{FailureKind::kInfeasible,
                  FailureCode::kLimits,
                  "PlanWalk",
                  "'FL_thigh_joint' moves too fast",
                  {{"speed", 0.4, Certainty::kPlanned, "--speed 0.4"},
                   {"gait", "jump", Certainty::kUntried, "--gait jump"},
                   {"gait.cycle_s", std::monostate(), Certainty::kEstimated, "a shorter cycle"},
                   "another gait"},
                  Violation{Law::kJointVelocity, 0.5, "FL_thigh_joint", 22.0, 21.0, "rad/s"}};
  const Json json = Json::parse(FailureJson(failure));
  EXPECT_EQ(json.at("code"), "limits");
  EXPECT_EQ(json.at("hints"), Json({"--speed 0.4", "--gait jump", "a shorter cycle", "another gait"}));
  const Json& suggestions = json.at("suggestions");
  ASSERT_EQ(suggestions.size(), 3U) << "advice in words names no option";
  EXPECT_EQ(suggestions[0], Json({{"what", "speed"}, {"value", 0.4}, {"certainty", "planned"}}));
  EXPECT_EQ(suggestions[1], Json({{"what", "gait"}, {"value", "jump"}, {"certainty", "untried"}}));
  EXPECT_EQ(suggestions[2], Json({{"what", "gait.cycle_s"}, {"value", nullptr}, {"certainty", "estimated"}}));
  EXPECT_EQ(json.at("violation").at("law"), "joint_velocity");
  EXPECT_EQ(json.at("violation").at("value"), 22.0);
  failure.violation.reset();
  EXPECT_FALSE(Json::parse(FailureJson(failure)).contains("violation"));
}

}  // namespace
}  // namespace gaitwright
