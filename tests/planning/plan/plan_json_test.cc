// SPDX-License-Identifier: BSD-3-Clause
// Plan files with one error: each is refused with a message that names the error.
#include "planning/plan/plan_json.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <nlohmann/json.hpp>

#include "tests/planning/audit/good_plan.h"

namespace gaitwright {
namespace {

using Json = nlohmann::ordered_json;

const std::string& GoodText() {
  static const std::string text = PlanToJson(GoodPlanOf("a1").plan);
  return text;
}

/// The reason why a text is refused; empty if it is accepted.
std::string ReasonPlanJsonRefused(const std::string& text) {
  const Result<MotionPlan> plan = PlanFromJson(text, "x.json");
  if (plan.ok()) return "";
  EXPECT_EQ(plan.failure().kind, FailureKind::kBadInput);
  EXPECT_EQ(plan.failure().message.find("json.exception"), std::string::npos) << plan.failure().message;
  const std::string start = "'x.json' is refused: ";
  EXPECT_EQ(plan.failure().message.rfind(start, 0), 0U) << plan.failure().message;
  return plan.failure().message.substr(start.size());
}

std::string ReasonPlanJsonRefused(const std::function<void(Json&)>& change) {
  static const Json good = Json::parse(GoodText());
  Json changed = good;
  change(changed);
  return ReasonPlanJsonRefused(changed.dump());
}

/// The good text with the first number after a key replaced by a word that JSON does not know.
std::string WithWord(const std::string& key, const std::string& word) {
  std::string text = GoodText();
  const std::size_t first = text.find_first_of("-0123456789", text.find("\"" + key + "\":") + key.size() + 3);
  const std::size_t last = text.find_first_of(",]}", first);
  return text.replace(first, last - first, word);
}

TEST(PlanJson, AGoodPlanComesBack) {
  EXPECT_EQ(ReasonPlanJsonRefused(GoodText()), "");
  const MotionPlan& good = GoodPlanOf("a1").plan;
  const MotionPlan back = PlanFromJson(GoodText(), "x.json").value();
  EXPECT_EQ(back.whole_body.q, good.whole_body.q);
  EXPECT_EQ(back.whole_body.wrenches, good.whole_body.wrenches);
  EXPECT_EQ(back.centroidal.p_WZ, good.centroidal.p_WZ);
  ASSERT_EQ(back.parts.size(), 1U);
  EXPECT_EQ(back.parts.front().command, good.parts.front().command);
  EXPECT_EQ(back.parts.front().goal, good.goal);
  EXPECT_EQ(back.parts.front().end_s, good.schedule.end_s());
  EXPECT_EQ(back.provenance, good.provenance);
  EXPECT_EQ(back.parts.front().gait, good.parts.front().gait);
  ASSERT_EQ(back.footsteps.footholds.size(), good.footsteps.footholds.size());
  EXPECT_TRUE(back.footsteps.footholds.back().X_WF.isApprox(good.footsteps.footholds.back().X_WF, 1e-12));
}

TEST(PlanJson, PartsComeBackInTheirOrder) {
  MotionPlan plan = GoodPlanOf("a1").plan;
  MotionPart stand{StandingGait(4), {}, plan.goal, plan.parts.front().end_s, plan.parts.front().end_s + 1.0};
  stand.command.extent = WalkCommand::Extent::kDuration;
  stand.command.duration_s = 1.0;
  plan.parts.push_back(stand);
  const MotionPlan back = PlanFromJson(PlanToJson(plan), "x.json").value();
  ASSERT_EQ(back.parts.size(), 2U);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(back.parts[k].gait, plan.parts[k].gait);
    EXPECT_EQ(back.parts[k].command, plan.parts[k].command);
    EXPECT_EQ(back.parts[k].goal, plan.parts[k].goal);
    EXPECT_EQ(back.parts[k].start_s, plan.parts[k].start_s);
    EXPECT_EQ(back.parts[k].end_s, plan.parts[k].end_s);
  }
  EXPECT_TRUE(StandsStill(back.parts[1].gait));
  EXPECT_EQ(GaitNames(back.parts), plan.parts[0].gait.name + ", stand");
  EXPECT_EQ(PartAt(back.parts, stand.start_s), &back.parts[1]) << "the later of two that meet";
  EXPECT_EQ(PartAt(back.parts, -1.0), &back.parts[0]);
  EXPECT_EQ(PartAt(back.parts, 1e3), &back.parts[1]);
  EXPECT_EQ(PartAt({}, 0.0), nullptr);
}

TEST(PlanJson, HeelOffComesBackWhereItIs) {
  EXPECT_EQ(GoodText().find("\"heel_off_s\""), std::string::npos) << "flat soles have none";
  MotionPlan plan = GoodPlanOf("nao").plan;
  plan.footsteps.footholds[1].heel_off_s = plan.footsteps.footholds[1].liftoff_s - 0.03;
  const MotionPlan back = PlanFromJson(PlanToJson(plan), "x.json").value();
  for (std::size_t i = 0; i < plan.footsteps.footholds.size(); ++i)
    EXPECT_EQ(back.footsteps.footholds[i].heel_off_s, plan.footsteps.footholds[i].heel_off_s) << i;
  EXPECT_NE(PlanHash(plan), PlanHash(GoodPlanOf("nao").plan));
}

TEST(PlanJson, NumbersThatAreNoneAreSaid) {
  for (const char* word : {"NaN", "nan", "Infinity", "-Infinity", "inf", "-inf", "1e999"}) {
    for (const char* key : {"speed_m_s", "centroidal", "q", "contact_wrenches"}) {
      const std::string why = ReasonPlanJsonRefused(WithWord(key, word));
      EXPECT_EQ(why.rfind(std::string("'") + key + "' contains " + word + " (byte ", 0), 0U) << why;
      EXPECT_NE(why.find("must be finite"), std::string::npos) << why;
    }
  }
  EXPECT_EQ(ReasonPlanJsonRefused([](Json& j) { j["goal"]["x_m"] = std::numeric_limits<double>::quiet_NaN(); }),
            "'goal.x_m' is null; a number is needed");
}

TEST(PlanJson, ASwingOverNoGroundComesBack) {
  MotionPlan plan = GoodPlanOf("a1").plan;
  plan.swings.front().clearance_m = std::numeric_limits<double>::infinity();
  const std::string text = PlanToJson(plan);
  const Result<MotionPlan> back = PlanFromJson(text, "x.json");
  ASSERT_TRUE(back.ok()) << back.failure().message;
  EXPECT_EQ(back->swings.front().clearance_m, plan.swings.front().clearance_m);
  EXPECT_EQ(back->swings.back().clearance_m, plan.swings.back().clearance_m);
  EXPECT_EQ(PlanToJson(*back), text);
}

TEST(PlanJson, TextsThatBreakSayWhere) {
  EXPECT_EQ(ReasonPlanJsonRefused(std::string()), "it is empty");
  const std::string& good = GoodText();
  EXPECT_EQ(ReasonPlanJsonRefused(good.substr(0, 100)),
            "its JSON is cut short at byte 100, after the key 'robot_hash'");
  EXPECT_EQ(ReasonPlanJsonRefused(good.substr(0, good.find("\"tau_nm\"") + 20)).find("its JSON is cut short at byte"),
            0U);
  EXPECT_EQ(
      ReasonPlanJsonRefused(good + "}}").find("its JSON has a syntax error at byte " + std::to_string(good.size() + 1)),
      0U);
  EXPECT_EQ(ReasonPlanJsonRefused(std::string("\x01\x02")), "its JSON has a syntax error at byte 1");
  EXPECT_EQ(ReasonPlanJsonRefused(std::string(100000, '[')),
            "its lists and objects are nested more than 64 levels deep, the maximum");
  EXPECT_EQ(ReasonPlanJsonRefused(std::string("[1, 2]")), "it is not a motion plan");
  EXPECT_EQ(ReasonPlanJsonRefused(std::string("{\"format\": \"x\"}")), "it is not a motion plan");
}

TEST(PlanJson, AKeyThatStandsTwiceIsRefused) {
  std::string text = GoodText();
  const std::string key = "\"step_s\":";
  text.insert(text.find(key), "\"step_s\":0.005,");
  EXPECT_EQ(ReasonPlanJsonRefused(text), "the key 'step_s' appears twice in one object");
}

}  // namespace
}  // namespace gaitwright
