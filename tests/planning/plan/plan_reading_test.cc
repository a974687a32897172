// SPDX-License-Identifier: BSD-3-Clause
// The parts of a plan file: each wrong value is refused with its place, the value and what is accepted.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>

#include "planning/plan/plan_json.h"
#include "planning/plan/plan_reading_internal.h"
#include "tests/planning/audit/good_plan.h"

namespace gaitwright {
namespace {

using ReadJson = nlohmann::ordered_json;

const ReadJson& GoodReadJson() {
  static const ReadJson json = ReadJson::parse(PlanToJson(GoodPlanOf("a1").plan));
  return json;
}

/// The reason why the good plan with a change is refused; empty if it is accepted.
std::string ReasonPlanRefused(const std::function<void(ReadJson&)>& change) {
  ReadJson changed = GoodReadJson();
  change(changed);
  const Result<MotionPlan> plan = PlanFromJson(changed.dump(), "x.json");
  if (plan.ok()) return "";
  EXPECT_EQ(plan.failure().kind, FailureKind::kBadInput);
  const std::string start = "'x.json' is refused: ";
  EXPECT_EQ(plan.failure().message.rfind(start, 0), 0U) << plan.failure().message;
  return plan.failure().message.substr(start.size());
}

TEST(PlanReading, PartsThatCannotBeAreRefused) {
  EXPECT_EQ(ReasonPlanRefused([](ReadJson& j) { j["parts"] = ReadJson::array(); }),
            "'parts' is empty; a plan has one part or more");
  EXPECT_NE(ReasonPlanRefused([](ReadJson& j) { j["parts"][0]["end_s"] = -1.0; }).find("it must end after its start"),
            std::string::npos);
  EXPECT_NE(ReasonPlanRefused([](ReadJson& j) { j["parts"][0]["speed"] = 1.0; }).find("'speed'"), std::string::npos);
}

TEST(PlanReading, KeysThatAreUnknownOrMissingAreNamed) {
  EXPECT_EQ(ReasonPlanRefused([](ReadJson& j) { j["footholdz"] = 1; }),
            "it has an unknown key 'footholdz'; the nearest is 'footholds'");
  EXPECT_EQ(ReasonPlanRefused([](ReadJson& j) { j["swings"][2]["lift"] = 1; }),
            "'swings[2]' has an unknown key 'lift'; the nearest is 'lift_m'");
  EXPECT_EQ(ReasonPlanRefused([](ReadJson& j) { j.erase("tau_nm"); }), "it lacks 'tau_nm'");
  EXPECT_EQ(ReasonPlanRefused([](ReadJson& j) { j["provenance"] = ReadJson::object(); }),
            "'provenance' lacks 'program_version'");
  EXPECT_EQ(ReasonPlanRefused([](ReadJson& j) { j["footholds"][1].erase("patch"); }), "'footholds[1]' lacks 'patch'");
  EXPECT_EQ(ReasonPlanRefused([](ReadJson& j) { j["terrain"]["patches"][0].erase("friction"); }),
            "'terrain.patches[0]' lacks 'friction'");
}

TEST(PlanReading, KindsThatAreWrongAreNamed) {
  EXPECT_EQ(ReasonPlanRefused([](ReadJson& j) { j["schema"] = "2"; }), "'schema' is '2'; a whole number is needed");
  EXPECT_EQ(ReasonPlanRefused([](ReadJson& j) { j["robot"] = 5; }), "'robot' is 5; a text is needed");
  EXPECT_EQ(ReasonPlanRefused([](ReadJson& j) {
              j["goal"] = ReadJson::array({1, 2});
            }),
            "'goal' is a list of 2; an object is needed");
  EXPECT_EQ(ReasonPlanRefused([](ReadJson& j) { j["footholds"][0]["foot"] = 0.5; }),
            "'footholds[0].foot' is 0.5; a whole number is needed");
  EXPECT_EQ(ReasonPlanRefused([](ReadJson& j) { j["q"][5][2] = "high"; }), "'q[5][2]' is 'high'; a number is needed");
  EXPECT_EQ(ReasonPlanRefused([](ReadJson& j) { j["q"] = true; }), "'q' is true; a list is needed");
  EXPECT_EQ(ReasonPlanRefused([](ReadJson& j) { j["schedule"][0][2] = -1; }),
            "'schedule[0][2]' is -1; a whole number, 0 or more, is needed");
  EXPECT_EQ(ReasonPlanRefused([](ReadJson& j) { j["schedule"][0].erase(2); }),
            "'schedule[0]' has 2 values; three are needed: start, end and stance");
  EXPECT_EQ(ReasonPlanRefused([](ReadJson& j) { j["provenance"]["options"]["a"] = 1; }),
            "'provenance.options.a' is 1; a text is needed");
}

TEST(PlanReading, IndicesAndChoicesThatAreNotThereAreRefused) {
  EXPECT_EQ(ReasonPlanRefused([](ReadJson& j) { j["footholds"][0]["foot"] = 9; }),
            "'footholds[0].foot' is 9; accepted: 0 to 3");
  EXPECT_EQ(ReasonPlanRefused([](ReadJson& j) { j["swings"][0]["foot"] = -1; }),
            "'swings[0].foot' is -1; accepted: 0 to 3");
  EXPECT_EQ(ReasonPlanRefused([](ReadJson& j) { j["footholds"][3]["patch"] = 77; }),
            "'footholds[3].patch' is 77; accepted: 0 to 0");
  EXPECT_EQ(ReasonPlanRefused([](ReadJson& j) { j["swings"][0]["foot"] = std::uint64_t{1} << 63U; }),
            "'swings[0].foot' is 9223372036854775808; accepted: 0 to 3");
  EXPECT_EQ(ReasonPlanRefused([](ReadJson& j) {
              j["schedule"][0][2] = std::uint64_t{1} << 40U;
            }).find("contact phase 0 names a foot "),
            0U);
  EXPECT_EQ(ReasonPlanRefused([](ReadJson& j) { j["parts"][0]["command"]["extent"] = "foo"; }),
            "'parts[0].command.extent' is 'foo'; accepted: 'distance', 'goal', 'steps', 'duration'");
  EXPECT_EQ(ReasonPlanRefused([](ReadJson& j) { j["parts"][0]["gait"]["phase"] = ReadJson::array({0}); }),
            "'parts[0].gait.phase' has 1 numbers; 4 are needed");
}

TEST(PlanReading, ValuesThatCannotBeAreRefused) {
  EXPECT_EQ(ReasonPlanRefused([](ReadJson& j) { j["footholds"][0]["pose"][6] = 0.0; }),
            "'footholds[0].pose' has a quaternion of length 0; it must be 1");
  EXPECT_EQ(ReasonPlanRefused([](ReadJson& j) { j["swings"][1]["end_pose"][6] = 1.5; }),
            "'swings[1].end_pose' has a quaternion of length 1.5; it must be 1");
  EXPECT_EQ(ReasonPlanRefused([](ReadJson& j) { j["q"][7][6] = 0.5; }).find("'q[7]' has a quaternion of length 0.5"),
            0U);
  EXPECT_EQ(ReasonPlanRefused([](ReadJson& j) { j["terrain"]["patches"][0]["friction"] = -1.0; }),
            "'terrain.patches[0].friction' is -1; accepted: 0 to 100");
  EXPECT_EQ(ReasonPlanRefused([](ReadJson& j) { j["terrain"]["patches"] = ReadJson::array(); }),
            "'terrain' has neither patches nor height fields; a plan needs ground to stand on");
  EXPECT_EQ(ReasonPlanRefused([](ReadJson& j) {
              j["terrain"]["patches"][0]["outline_m"] = {{0, 0}, {1, 0}};
            }),
            "'terrain.patches[0].outline_m' has 2 corners; accepted: none (an infinite plane), or three or more (an "
            "outline)");
  EXPECT_EQ(ReasonPlanRefused([](ReadJson& j) {
              j["terrain"]["patches"][0]["outline_m"] = {{0, 0}, {0, 9}, {9, 9}, {9, 0}};
            }),
            "'terrain.patches[0].outline_m' runs clockwise; it must run counter-clockwise");
  EXPECT_EQ(ReasonPlanRefused([](ReadJson& j) {
              j["terrain"]["patches"][0]["outline_m"] = {{-9, -9}, {9, -9}, {0, 0}, {9, 9}, {-9, 9}};
            }).find("'terrain.patches[0].outline_m' covers 0.75 of its convex hull"),
            0U);
  EXPECT_EQ(ReasonPlanRefused([](ReadJson& j) { j["parts"][0]["gait"]["cycle_s"] = 0.0; }),
            "'parts[0].gait.cycle_s' is 0; it must be above 0");
  EXPECT_EQ(ReasonPlanRefused([](ReadJson& j) { j["terrain"]["patches"][0]["pose"] = {0, 0, 0, 1, 0, 0, 0}; }),
            "'terrain.patches[0]' faces down: the z of its normal is -1; it must be above 0");
  EXPECT_EQ(ReasonPlanRefused([](ReadJson& j) { j["step_s"] = 0; }), "'step_s' is 0; it must be positive");
  EXPECT_EQ(ReasonPlanRefused([](ReadJson& j) {
              j["swings"][0]["end_s"] = j["swings"][0]["start_s"];
            }).find("'swings[0]' lasts from "),
            0U);
}

TEST(PlanReading, FootholdsComeBackInOrder) {
  ReadJson j = GoodReadJson();
  ReadJson& footholds = j["footholds"];
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

TEST(PlanReading, RowsThatDoNotBelongTogetherAreRefused) {
  const std::size_t rows = GoodPlanOf("a1").plan.whole_body.q.size();
  EXPECT_EQ(ReasonPlanRefused([](ReadJson& j) { j["q"][5].erase(0); }),
            "'q[5]' has 18 numbers, but the first row has 19");
  EXPECT_EQ(ReasonPlanRefused([](ReadJson& j) { j["v"].erase(0); }),
            "'v' has " + std::to_string(rows - 1) + " rows; " + std::to_string(rows) + " are needed");
  EXPECT_EQ(ReasonPlanRefused([](ReadJson& j) { j["q"] = ReadJson::array(); }), "'q' has 0 rows; 1 are needed");
  EXPECT_EQ(ReasonPlanRefused([](ReadJson& j) {
              for (ReadJson& row : j["tau_nm"]) row.erase(0);
            }).find("it has rows of 19, 18, 18 and 11 numbers in 'q', 'v', 'a' and 'tau_nm'"),
            0U);
  EXPECT_EQ(ReasonPlanRefused([](ReadJson& j) {
              for (ReadJson& row : j["contact_wrenches"]) row.erase(0);
            }),
            "'contact_wrenches' has rows of 23 numbers; each foot has six");
  EXPECT_EQ(ReasonPlanRefused([](ReadJson& j) {
              for (ReadJson& row : j["centroidal"]) row.erase(0);
            }),
            "'centroidal' has rows of 10 numbers; 11 are needed");
}

/// A box on the ground, as in a plan file.
ReadJson BoxOfReading() {
  return {{"name", "post"}, {"type", "box"}, {"pose", {5, 0, 0.5, 0, 0, 0, 1}}, {"size_m", {0.1, 0.2, 1.0}}};
}

TEST(PlanReading, ObstaclesNeedTheKeyOfTheirTypeAndSizesAboveZero) {
  const auto why = [](const std::function<void(ReadJson&)>& change) {
    return ReasonPlanRefused([&](ReadJson& j) {
      ReadJson box = BoxOfReading();
      change(box);
      j["terrain"]["obstacles"] = ReadJson::array({box});
    });
  };
  EXPECT_EQ(why([](ReadJson&) {}), "");
  EXPECT_EQ(why([](ReadJson& box) { box["size_m"][1] = 0.0; }),
            "'terrain.obstacles[0].size_m' has a size of 0; it must be above 0");
  EXPECT_EQ(why([](ReadJson& box) { box["type"] = "cylinder"; }),
            "'terrain.obstacles[0].size_m' has 3 numbers; 2 are needed");
  EXPECT_NE(why([](ReadJson& box) { box["type"] = "mesh"; }), "") << "a mesh has vertices, not sizes";
  EXPECT_NE(why([](ReadJson& box) { box["vertices_m"] = ReadJson::array(); }), "") << "a box has no vertices";
  EXPECT_EQ(why([](ReadJson& box) {
              box.erase("size_m");
              box["type"] = "mesh";
              box["vertices_m"] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
            }),
            "'terrain.obstacles[0].vertices_m' has 3 points; four or more are needed");
}

TEST(PlanReading, AHeightFieldHasAHeightForEachNode) {
  const ReadJson good = {{"name", "field"}, {"origin_m", {0, 0}}, {"resolution_m", 0.5},
                         {"columns", 3},    {"rows", 2},          {"heights_m", {0, 1, 2, 3, 4, 5}},
                         {"friction", 0.7}};
  const auto why = [&](const char* key, const ReadJson& value) {
    return ReasonPlanRefused([&](ReadJson& j) {
      ReadJson field = good;
      field[key] = value;
      j["terrain"]["height_fields"] = ReadJson::array({field});
    });
  };
  EXPECT_EQ(why("friction", 0.5), "");
  EXPECT_EQ(why("columns", 4), "'terrain.height_fields[0].heights_m' has 6 numbers; 4 columns by 2 rows need 8");
  EXPECT_EQ(why("resolution_m", 0.0), "'terrain.height_fields[0].resolution_m' is 0; it must be above 0");
  EXPECT_EQ(why("rows", 1).find("'terrain.height_fields[0].rows' is 1; accepted: 2 to "), 0U);
}

TEST(PlanReading, AFootThatNeverStandsNeedsAllFeetToDoSo) {
  const auto shares = [](const ReadJson& duty) {
    return ReasonPlanRefused([&](ReadJson& j) { j["parts"][0]["gait"]["duty_factor"] = duty; });
  };
  EXPECT_EQ(shares({0, 0, 0, 0}), "");
  EXPECT_EQ(shares({0.5, 0.5, 0, 0.5}),
            "'parts[0].gait.duty_factor[2]' is 0; a foot that never stands is accepted only if no foot ever stands");
  EXPECT_EQ(ReasonPlanRefused([](ReadJson& j) { j["parts"][0]["gait"]["phase"][1] = 1.0; }),
            "'parts[0].gait.phase[1]' is 1; a phase must be less than 1");
}

TEST(PlanReading, AFootholdMayNotEndBeforeItBegins) {
  EXPECT_EQ(ReasonPlanRefused([](ReadJson& j) {
              j["footholds"][0]["touchdown_s"] = 2.0;
              j["footholds"][0]["liftoff_s"] = 1.5;
            }),
            "'footholds[0]' lifts off before it touches down");
}

TEST(PlanReading, AHeelRisesWithinItsStance) {
  const auto with = [](double heel_off_s) {
    return ReasonPlanRefused([&](ReadJson& j) {
      j["footholds"][0]["touchdown_s"] = 0.5;
      j["footholds"][0]["liftoff_s"] = 1.5;
      j["footholds"][0]["heel_off_s"] = heel_off_s;
    });
  };
  EXPECT_EQ(with(1.4), "");
  EXPECT_EQ(with(1.6), "'footholds[0]' has 'heel_off_s' 1.6; accepted: from 'touchdown_s' 0.5 to 'liftoff_s' 1.5");
  EXPECT_EQ(with(0.4).find("'footholds[0]' has 'heel_off_s' 0.4; accepted: from"), 0U);
}

TEST(PlanReading, ASwingCruisesForLessThanItsTime) {
  EXPECT_EQ(ReasonPlanRefused([](ReadJson& j) { j["swings"][0]["cruise"] = 0.99; }), "");
  for (const double cruise : {-0.5, 1.0}) {
    EXPECT_EQ(
        ReasonPlanRefused([&](ReadJson& j) { j["swings"][0]["cruise"] = cruise; }).find("'swings[0]' has 'cruise' "),
        0U)
        << cruise;
  }
}

TEST(PlanReading, GatesNameFeetThatAPlanHas) {
  const auto gated = [](int contact) {
    return ReasonPlanRefused([&](ReadJson& j) {
      j["gates"] = ReadJson::array(
          {{{"at_s", 0.1}, {"phase", "stand"}, {"joints_within", 0.1}, {"contact", contact}, {"longest_s", 1.0}}});
    });
  };
  EXPECT_EQ(gated(15), "");
  EXPECT_EQ(gated(16), "'gates[0].contact' names a foot beyond the robot's 4 feet");
}

TEST(PlanReading, AnAdjustmentHasACodeOfAFailure) {
  const auto adjusted = [](const char* why) {
    return ReasonPlanRefused([&](ReadJson& j) {
      j["adjustments"] = ReadJson::array(
          {{{"what", "speed_m_s"}, {"asked", 1.0}, {"given", 0.5}, {"unit", "m/s"}, {"why", why}, {"part", ""}}});
    });
  };
  EXPECT_EQ(adjusted(FailureCodeName(FailureCode::kReach).c_str()), "");
  EXPECT_EQ(adjusted("tired"), "'adjustments[0].why' is 'tired', which is not a failure code");
}

TEST(PlanReading, ExtentsAreInTheOrderOfTheCommand) {
  using Extent = WalkCommand::Extent;
  EXPECT_EQ(PlanExtents().at(static_cast<std::size_t>(Extent::kDistance)), "distance");
  EXPECT_EQ(PlanExtents().at(static_cast<std::size_t>(Extent::kGoal)), "goal");
  EXPECT_EQ(PlanExtents().at(static_cast<std::size_t>(Extent::kSteps)), "steps");
  EXPECT_EQ(PlanExtents().at(static_cast<std::size_t>(Extent::kDuration)), "duration");
  EXPECT_EQ(PlanExtents().size(), 4U);
}

}  // namespace
}  // namespace gaitwright
