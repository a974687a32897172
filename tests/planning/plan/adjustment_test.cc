// SPDX-License-Identifier: BSD-3-Clause
#include "planning/plan/adjustment.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "planning/plan/plan_json.h"
#include "tests/planning/audit/good_plan.h"

namespace gaitwright {
namespace {

using Json = nlohmann::ordered_json;

const std::vector<Adjustment>& Examples() {
  static const std::vector<Adjustment> examples = {{"gait.cycle_s", 0.5, 0.45, "s", FailureCode::kJointVelocity, ""},
                                                   {"speed", 1.0, 0.7, "m/s", FailureCode::kLimits, "2: trot"}};
  return examples;
}

TEST(Adjustment, APlanKeepsThemInItsFile) {
  MotionPlan plan = GoodPlanOf("a1").plan;
  plan.adjustments = Examples();
  const Result<MotionPlan> back = PlanFromJson(PlanToJson(plan), "x.json");
  ASSERT_TRUE(back.ok()) << back.failure().message;
  EXPECT_EQ(back->adjustments, Examples());
}

TEST(Adjustment, APlanWithoutAnyHasNoKeyForThem) {
  EXPECT_FALSE(Json::parse(PlanToJson(GoodPlanOf("a1").plan)).contains("adjustments"));
}

TEST(Adjustment, AnUnknownReasonIsRefused) {
  MotionPlan plan = GoodPlanOf("a1").plan;
  plan.adjustments = Examples();
  Json json = Json::parse(PlanToJson(plan));
  json["adjustments"][1]["why"] = "the weather";
  const Result<MotionPlan> back = PlanFromJson(json.dump(), "x.json");
  ASSERT_FALSE(back.ok());
  EXPECT_EQ(back.failure().code, FailureCode::kPlanFile);
  EXPECT_NE(back.failure().message.find("the weather"), std::string::npos) << back.failure().message;
}

TEST(Adjustment, TheTextHasBothValuesTheirUnitAndTheReason) {
  for (const Adjustment& adjustment : Examples()) {
    const std::string text = AdjustmentText(adjustment);
    for (const std::string& part : {std::string(FailureCodeName(adjustment.why)), adjustment.unit, adjustment.part})
      EXPECT_NE(text.find(part), std::string::npos) << text;
    EXPECT_LT(text.find(adjustment.what == "speed" ? "0.7" : "0.45"),
              text.find(adjustment.what == "speed" ? "1 " : "0.5 "))
        << text;
  }
}

}  // namespace
}  // namespace gaitwright
