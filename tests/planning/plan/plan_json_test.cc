// SPDX-License-Identifier: BSD-3-Clause
// Plan files with one thing wrong: refused, with that thing named in words of our own.
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

/// Why a text is refused; empty when it is not.
std::string WhyPlanJsonRefused(const std::string& text) {
  const Result<MotionPlan> plan = PlanFromJson(text, "x.json");
  if (plan.ok()) return "";
  EXPECT_EQ(plan.failure().kind, FailureKind::kBadInput);
  EXPECT_EQ(plan.failure().message.find("json.exception"), std::string::npos) << plan.failure().message;
  const std::string start = "'x.json' is refused: ";
  EXPECT_EQ(plan.failure().message.rfind(start, 0), 0U) << plan.failure().message;
  return plan.failure().message.substr(start.size());
}

std::string WhyPlanJsonRefused(const std::function<void(Json&)>& change) {
  static const Json good = Json::parse(GoodText());
  Json changed = good;
  change(changed);
  return WhyPlanJsonRefused(changed.dump());
}

/// The good text with the first number after a key replaced by a word that JSON does not know.
std::string WithWord(const std::string& key, const std::string& word) {
  std::string text = GoodText();
  const std::size_t first = text.find_first_of("-0123456789", text.find("\"" + key + "\":") + key.size() + 3);
  const std::size_t last = text.find_first_of(",]}", first);
  return text.replace(first, last - first, word);
}

TEST(PlanJson, AGoodPlanComesBack) {
  EXPECT_EQ(WhyPlanJsonRefused(GoodText()), "");
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

TEST(PlanJson, PartsThatCannotBeAreRefused) {
  EXPECT_EQ(WhyPlanJsonRefused([](Json& j) { j["parts"] = Json::array(); }),
            "'parts' is empty; a plan has one part or more");
  EXPECT_NE(WhyPlanJsonRefused([](Json& j) { j["parts"][0]["end_s"] = -1.0; }).find("it must end after its start"),
            std::string::npos);
  EXPECT_NE(WhyPlanJsonRefused([](Json& j) { j["parts"][0]["speed"] = 1.0; }).find("'speed'"), std::string::npos);
}

TEST(PlanJson, NumbersThatAreNoneAreSaid) {
  for (const char* word : {"NaN", "nan", "Infinity", "-Infinity", "inf", "-inf", "1e999"}) {
    for (const char* key : {"speed_m_s", "centroidal", "q", "contact_wrenches"}) {
      const std::string why = WhyPlanJsonRefused(WithWord(key, word));
      EXPECT_EQ(why.rfind(std::string("'") + key + "' contains " + word + " (byte ", 0), 0U) << why;
      EXPECT_NE(why.find("must be finite"), std::string::npos) << why;
    }
  }
  EXPECT_EQ(WhyPlanJsonRefused([](Json& j) { j["goal"]["x_m"] = std::numeric_limits<double>::quiet_NaN(); }),
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
  EXPECT_EQ(WhyPlanJsonRefused(std::string()), "it is empty");
  const std::string& good = GoodText();
  EXPECT_EQ(WhyPlanJsonRefused(good.substr(0, 100)), "its JSON is cut short at byte 100, after the key 'robot_hash'");
  EXPECT_EQ(WhyPlanJsonRefused(good.substr(0, good.find("\"tau_nm\"") + 20)).find("its JSON is cut short at byte"), 0U);
  EXPECT_EQ(WhyPlanJsonRefused(good + "}}").find("its JSON is broken at byte " + std::to_string(good.size() + 1)), 0U);
  EXPECT_EQ(WhyPlanJsonRefused(std::string("\x01\x02")), "its JSON is broken at byte 1");
  EXPECT_EQ(WhyPlanJsonRefused(std::string(100000, '[')), "its lists and objects are nested more than 64 levels deep");
  EXPECT_EQ(WhyPlanJsonRefused(std::string("[1, 2]")), "it is not a motion plan");
  EXPECT_EQ(WhyPlanJsonRefused(std::string("{\"format\": \"x\"}")), "it is not a motion plan");
}

TEST(PlanJson, AKeyThatStandsTwiceIsRefused) {
  std::string text = GoodText();
  const std::string key = "\"step_s\":";
  text.insert(text.find(key), "\"step_s\":0.005,");
  EXPECT_EQ(WhyPlanJsonRefused(text), "the key 'step_s' is in one object twice");
}

TEST(PlanJson, KeysThatAreUnknownOrMissingAreNamed) {
  EXPECT_EQ(WhyPlanJsonRefused([](Json& j) { j["footholdz"] = 1; }),
            "it has an unknown key 'footholdz'; the nearest is 'footholds'");
  EXPECT_EQ(WhyPlanJsonRefused([](Json& j) { j["swings"][2]["lift"] = 1; }),
            "'swings[2]' has an unknown key 'lift'; the nearest is 'lift_m'");
  EXPECT_EQ(WhyPlanJsonRefused([](Json& j) { j.erase("tau_nm"); }), "it lacks 'tau_nm'");
  EXPECT_EQ(WhyPlanJsonRefused([](Json& j) { j["provenance"] = Json::object(); }),
            "'provenance' lacks 'program_version'");
  EXPECT_EQ(WhyPlanJsonRefused([](Json& j) { j["footholds"][1].erase("patch"); }), "'footholds[1]' lacks 'patch'");
  EXPECT_EQ(WhyPlanJsonRefused([](Json& j) { j["terrain"]["patches"][0].erase("friction"); }),
            "'terrain.patches[0]' lacks 'friction'");
}

TEST(PlanJson, KindsThatAreWrongAreNamed) {
  EXPECT_EQ(WhyPlanJsonRefused([](Json& j) { j["schema"] = "2"; }), "'schema' is '2'; a whole number is needed");
  EXPECT_EQ(WhyPlanJsonRefused([](Json& j) { j["robot"] = 5; }), "'robot' is 5; a text is needed");
  EXPECT_EQ(WhyPlanJsonRefused([](Json& j) {
              j["goal"] = Json::array({1, 2});
            }),
            "'goal' is a list of 2; an object is needed");
  EXPECT_EQ(WhyPlanJsonRefused([](Json& j) { j["footholds"][0]["foot"] = 0.5; }),
            "'footholds[0].foot' is 0.5; a whole number is needed");
  EXPECT_EQ(WhyPlanJsonRefused([](Json& j) { j["q"][5][2] = "high"; }), "'q[5][2]' is 'high'; a number is needed");
  EXPECT_EQ(WhyPlanJsonRefused([](Json& j) { j["q"] = true; }), "'q' is true; a list is needed");
  EXPECT_EQ(WhyPlanJsonRefused([](Json& j) { j["schedule"][0][2] = -1; }),
            "'schedule[0][2]' is -1; a whole number, 0 or more, is needed");
  EXPECT_EQ(WhyPlanJsonRefused([](Json& j) { j["schedule"][0].erase(2); }),
            "'schedule[0]' has 2 parts; start, end and stance are needed");
  EXPECT_EQ(WhyPlanJsonRefused([](Json& j) { j["provenance"]["options"]["a"] = 1; }),
            "'provenance.options.a' is 1; a text is needed");
}

TEST(PlanJson, IndicesAndChoicesThatAreNotThereAreRefused) {
  EXPECT_EQ(WhyPlanJsonRefused([](Json& j) { j["footholds"][0]["foot"] = 9; }),
            "'footholds[0].foot' is 9; accepted: 0 to 3");
  EXPECT_EQ(WhyPlanJsonRefused([](Json& j) { j["swings"][0]["foot"] = -1; }),
            "'swings[0].foot' is -1; accepted: 0 to 3");
  EXPECT_EQ(WhyPlanJsonRefused([](Json& j) { j["footholds"][3]["patch"] = 77; }),
            "'footholds[3].patch' is 77; accepted: 0 to 0");
  EXPECT_EQ(WhyPlanJsonRefused([](Json& j) { j["swings"][0]["foot"] = std::uint64_t{1} << 63U; }),
            "'swings[0].foot' is 9223372036854775808; accepted: 0 to 3");
  EXPECT_EQ(WhyPlanJsonRefused([](Json& j) {
              j["schedule"][0][2] = std::uint64_t{1} << 40U;
            }).find("contact phase 0 names a foot "),
            0U);
  EXPECT_EQ(WhyPlanJsonRefused([](Json& j) { j["parts"][0]["command"]["extent"] = "foo"; }),
            "'parts[0].command.extent' is 'foo'; accepted: 'distance', 'goal', 'steps', 'duration'");
  EXPECT_EQ(WhyPlanJsonRefused([](Json& j) { j["parts"][0]["gait"]["phase"] = Json::array({0}); }),
            "'parts[0].gait.phase' has 1 numbers; 4 are needed");
}

TEST(PlanJson, ValuesThatCannotBeAreRefused) {
  EXPECT_EQ(WhyPlanJsonRefused([](Json& j) { j["footholds"][0]["pose"][6] = 0.0; }),
            "'footholds[0].pose' has a quaternion of length 0; it must be 1");
  EXPECT_EQ(WhyPlanJsonRefused([](Json& j) { j["swings"][1]["end_pose"][6] = 1.5; }),
            "'swings[1].end_pose' has a quaternion of length 1.5; it must be 1");
  EXPECT_EQ(WhyPlanJsonRefused([](Json& j) { j["q"][7][6] = 0.5; }).find("'q[7]' has a quaternion of length 0.5"), 0U);
  EXPECT_EQ(WhyPlanJsonRefused([](Json& j) { j["terrain"]["patches"][0]["friction"] = -1.0; }),
            "'terrain.patches[0].friction' is -1; accepted: 0 to 100");
  EXPECT_EQ(WhyPlanJsonRefused([](Json& j) { j["terrain"]["patches"] = Json::array(); }),
            "'terrain' has neither patches nor height fields; a plan needs ground to stand on");
  EXPECT_EQ(WhyPlanJsonRefused([](Json& j) {
              j["terrain"]["patches"][0]["outline_m"] = {{0, 0}, {1, 0}};
            }),
            "'terrain.patches[0].outline_m' has 2 corners; accepted: none (an infinite plane), or three or more (an "
            "outline)");
  EXPECT_EQ(WhyPlanJsonRefused([](Json& j) {
              j["terrain"]["patches"][0]["outline_m"] = {{0, 0}, {0, 9}, {9, 9}, {9, 0}};
            }),
            "'terrain.patches[0].outline_m' runs clockwise; counter-clockwise is needed");
  EXPECT_EQ(WhyPlanJsonRefused([](Json& j) {
              j["terrain"]["patches"][0]["outline_m"] = {{-9, -9}, {9, -9}, {0, 0}, {9, 9}, {-9, 9}};
            }).find("'terrain.patches[0].outline_m' covers 0.75 of its convex hull"),
            0U);
  EXPECT_EQ(WhyPlanJsonRefused([](Json& j) { j["parts"][0]["gait"]["cycle_s"] = 0.0; }),
            "'parts[0].gait.cycle_s' is 0; it must be above 0");
  EXPECT_EQ(WhyPlanJsonRefused([](Json& j) { j["terrain"]["patches"][0]["pose"] = {0, 0, 0, 1, 0, 0, 0}; }),
            "'terrain.patches[0]' faces down: the z of its normal is -1; it must be above 0");
  EXPECT_EQ(WhyPlanJsonRefused([](Json& j) { j["step_s"] = 0; }), "'step_s' is 0; it must be positive");
  EXPECT_EQ(WhyPlanJsonRefused([](Json& j) {
              j["swings"][0]["end_s"] = j["swings"][0]["start_s"];
            }).find("'swings[0]' lasts from "),
            0U);
}

TEST(PlanJson, FootholdsComeBackInOrder) {
  Json j = Json::parse(GoodText());
  Json& footholds = j["footholds"];
  std::reverse(footholds.begin(), footholds.end());
  const Result<MotionPlan> back = PlanFromJson(j.dump(), "plan");
  ASSERT_TRUE(back.ok()) << back.failure().message;
  const MotionPlan& good = GoodPlanOf("a1").plan;
  ASSERT_EQ(back->footsteps.footholds.size(), good.footsteps.footholds.size());
  for (std::size_t i = 0; i < good.footsteps.footholds.size(); ++i) {
    EXPECT_EQ(back->footsteps.footholds[i].foot, good.footsteps.footholds[i].foot) << i;
    EXPECT_EQ(back->footsteps.footholds[i].touchdown_s, good.footsteps.footholds[i].touchdown_s) << i;
  }
}

TEST(PlanJson, RowsThatDoNotBelongTogetherAreRefused) {
  const std::size_t rows = GoodPlanOf("a1").plan.whole_body.q.size();
  EXPECT_EQ(WhyPlanJsonRefused([](Json& j) { j["q"][5].erase(0); }), "'q[5]' has 18 numbers, but the first row has 19");
  EXPECT_EQ(WhyPlanJsonRefused([](Json& j) { j["v"].erase(0); }),
            "'v' has " + std::to_string(rows - 1) + " rows; " + std::to_string(rows) + " are needed");
  EXPECT_EQ(WhyPlanJsonRefused([](Json& j) { j["q"] = Json::array(); }), "'q' has 0 rows; 1 are needed");
  EXPECT_EQ(WhyPlanJsonRefused([](Json& j) {
              for (Json& row : j["tau_nm"]) row.erase(0);
            }).find("it has rows of 19, 18, 18 and 11 numbers in 'q', 'v', 'a' and 'tau_nm'"),
            0U);
  EXPECT_EQ(WhyPlanJsonRefused([](Json& j) {
              for (Json& row : j["contact_wrenches"]) row.erase(0);
            }),
            "'contact_wrenches' has rows of 23 numbers; each foot has six");
  EXPECT_EQ(WhyPlanJsonRefused([](Json& j) {
              for (Json& row : j["centroidal"]) row.erase(0);
            }),
            "'centroidal' has rows of 10 numbers; 11 are needed");
}

}  // namespace
}  // namespace gaitwright
