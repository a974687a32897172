// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/sweep_files.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/workflows/study/made_up_sweep.h"

namespace gaitwright {
namespace {

using Json = nlohmann::ordered_json;

const std::vector<std::string> kOver = {"speed=0.3:0.7:5", "play.push_on=base,robot"};

TEST(SweepCsv, HasARowForEachPointWithAsManyCellsAsHeads) {
  const MadeUpSweep sweep = MakeUpSweep(kOver, 4);
  std::istringstream csv(SweepCsv(sweep.study, sweep.outcomes));
  std::string line;
  std::getline(csv, line);
  EXPECT_EQ(line,
            "point,speed,play.push_on,status,code,score,goal_error_m,zmp_margin_p05_m,fell_at_s,trials,survived,"
            "survival,survival_low,survival_high,trial_score_mean,reason");
  std::getline(csv, line);
  EXPECT_EQ(line.substr(0, 42), "0,0.3,base,pass,,70,0.01,,,4,4,1,0.5101091");
  int rows = 1;
  std::string last;
  for (; std::getline(csv, line); ++rows) {
    last = line;
    int cells = 1;
    bool quoted = false;
    for (const char c : line) {
      quoted = quoted != (c == '"');
      cells += c == ',' && !quoted ? 1 : 0;
    }
    EXPECT_EQ(cells, 16) << line;
  }
  EXPECT_EQ(rows, 10);
  EXPECT_NE(last.find("\"the knee, \"\"FL_calf\"\", needs too much\""), std::string::npos) << last;
}

/// The sweep with its first point played in two engines; the robot falls in the second.
MadeUpSweep SweepInTwoEngines() {
  MadeUpSweep sweep = MakeUpSweep(kOver, 0);
  sweep.study.play.play.world.engine = "both";
  sweep.outcomes[0].engines = {{"bullet", true, false, 70.5, ""}, {"mujoco", false, true, 20.25, "slipped"}};
  return sweep;
}

TEST(SweepCsv, HasVerdictAndScoreOfEachEngine) {
  const MadeUpSweep sweep = SweepInTwoEngines();
  std::istringstream csv(SweepCsv(sweep.study, sweep.outcomes));
  std::string head, first, second;
  std::getline(csv, head);
  std::getline(csv, first);
  std::getline(csv, second);
  const std::string names = ",fell_at_s,bullet_verdict,bullet_score,mujoco_verdict,mujoco_score,reason";
  EXPECT_EQ(head.substr(head.size() - names.size()), names);
  EXPECT_NE(first.find(",pass,70.5,fell,20.25,"), std::string::npos) << first;
  EXPECT_NE(second.find(",,,,,"), std::string::npos) << second << ": one that was not played in two";
}

TEST(SweepJson, APointHasTheVerdictsOfBothEngines) {
  const MadeUpSweep sweep = SweepInTwoEngines();
  const Json json = Json::parse(SweepJson(sweep.study, sweep.outcomes, {}));
  const Json& engines = json.at("points").at(0).at("engines");
  ASSERT_EQ(engines.size(), 2U);
  EXPECT_EQ(engines.at(1), (Json{{"engine", "mujoco"}, {"verdict", "fell"}, {"score", 20.25}, {"cause", "slipped"}}));
  EXPECT_FALSE(json.at("points").at(1).contains("engines"));
}

TEST(EnginesText, CountsWhereTheyAgreeAndIsEmptyForOneEngine) {
  EXPECT_EQ(EnginesText(SweepInTwoEngines().outcomes),
            "0 points pass in both, 1 only in Bullet, 0 only in MuJoCo, 0 in neither");
  EXPECT_EQ(EnginesText(MakeUpSweep(kOver, 0).outcomes), "");
}

TEST(SweepJson, HoldsAxesPointsBestCountsAndFiles) {
  const MadeUpSweep sweep = MakeUpSweep(kOver, 4);
  const Json json = Json::parse(SweepJson(sweep.study, sweep.outcomes, {{"map", "a.csv"}}));
  EXPECT_EQ(json.at("axes").at(0).at("values"), (Json{0.3, 0.4, 0.5, 0.6, 0.7}));
  EXPECT_EQ(json.at("axes").at(1).at("values"), (Json{"base", "robot"}));
  EXPECT_EQ(json.at("points").size(), 10U);
  EXPECT_EQ(json.at("points").at(3).at("values"), (Json{{"speed", 0.4}, {"play.push_on", "robot"}}));
  EXPECT_EQ(json.at("points").at(3).at("code"), "goal_error_m");
  EXPECT_EQ(json.at("points").at(4).at("fell_at_s"), 1.5);
  EXPECT_TRUE(json.at("points").at(8).at("audit_pass").is_null()) << "a refused point has no plan to audit";
  EXPECT_TRUE(json.at("points").at(8).at("survival").is_null());
  EXPECT_EQ(json.at("best").at("point"), 0);
  EXPECT_EQ(json.at("best_play_flags"), "--set play.push_on=base") << "the speed is the plan's";
  EXPECT_EQ(json.at("counts").at("points"), 10);
  EXPECT_EQ(json.at("counts").at("fell"), 2);
  EXPECT_EQ(json.at("files").at("map"), "a.csv");
}

}  // namespace
}  // namespace gaitwright
