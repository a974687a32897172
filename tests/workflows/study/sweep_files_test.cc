// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/sweep_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/workflows/study/made_up_sweep.h"

namespace gaitwright {
namespace {

using Json = nlohmann::ordered_json;

const std::vector<std::string> kOver = {"speed=0.3:0.7:5", "play.push_on=base,robot"};

TEST(SweepSummary, CountsEachStatusAndFindsTheBest) {
  const MadeUpSweep sweep = MakeUpSweep(kOver);
  const SweepSummary summary = SummaryOf(sweep.outcomes);
  for (const PointStatus status : kPointStatuses) EXPECT_EQ(summary.Count(status), 2) << StatusName(status);
  EXPECT_EQ(summary.best, 0U);
}

TEST(SweepSummary, WithoutAPlanThatPassesThereIsNoBest) {
  const MadeUpSweep sweep = MakeUpSweep({"speed=0.6,0.7"});
  EXPECT_EQ(SummaryOf(sweep.outcomes).best, std::nullopt);
  EXPECT_NE(SweepText(sweep.study, sweep.outcomes).find("best    none"), std::string::npos);
  EXPECT_TRUE(Json::parse(SweepJson(sweep.study, sweep.outcomes, {})).at("best").is_null());
}

TEST(SweepSummary, TheBestDoesNotDependOnTheOrderOfItsOutcomes) {
  MadeUpSweep sweep = MakeUpSweep(kOver, 4);
  const auto best = SummaryOf(sweep.outcomes).best;
  std::reverse(sweep.outcomes.begin(), sweep.outcomes.end());
  EXPECT_EQ(SummaryOf(sweep.outcomes).best, best);
}

TEST(FailureGroups, SayWhereAndWhy) {
  const MadeUpSweep sweep = MakeUpSweep({"speed=0.1:1:10", "play.push_on=base,robot"});
  const std::vector<FailureGroup> groups = FailureGroups(sweep.study, sweep.outcomes);
  ASSERT_EQ(groups.size(), 4U);
  EXPECT_EQ(groups[0].status, PointStatus::kRefused) << "the largest first";
  EXPECT_EQ(groups[0].points.size(), 8U);
  EXPECT_EQ(groups[0].where, "speed 0.7 to 1 m/s, play.push_on base or robot");
  EXPECT_EQ(groups[0].example, "the knee, \"FL_calf\", needs too much");
  EXPECT_EQ(groups[1].where, "speed 0.4 m/s, play.push_on base or robot");
}

TEST(FailureGroups, HaveNoPointAmongThemThatPasses) {
  MadeUpSweep sweep = MakeUpSweep({"speed=0.1:0.4:4", "play.friction=0.05,0.8"});
  for (PointOutcome& outcome : sweep.outcomes) {
    outcome = {};
    outcome.point = static_cast<std::size_t>(&outcome - sweep.outcomes.data());
    const std::string &speed = sweep.study.points[outcome.point][0], &friction = sweep.study.points[outcome.point][1];
    outcome.status = friction == "0.05" || speed == "0.4" ? PointStatus::kFell : PointStatus::kPass;
    outcome.reason = friction == "0.05" ? "slid" : "too fast";
  }
  const std::vector<FailureGroup> groups = FailureGroups(sweep.study, sweep.outcomes);
  ASSERT_EQ(groups.size(), 2U);
  EXPECT_EQ(groups[0].where, "speed 0.1 to 0.4 m/s, play.friction 0.05");
  EXPECT_EQ(groups[0].example, "slid");
  EXPECT_EQ(groups[1].where, "speed 0.4 m/s, play.friction 0.8");
  EXPECT_EQ(groups[1].example, "too fast");
}

TEST(FailureGroups, OfPointsAllOverEndInOneWithTheRest) {
  MadeUpSweep sweep = MakeUpSweep({"speed=0.1:1:10", "play.friction=0.4:0.8:9"});
  for (std::size_t i = 0; i < sweep.outcomes.size(); ++i) {
    sweep.outcomes[i] = {};
    sweep.outcomes[i].point = i;
    sweep.outcomes[i].status = (i / 9 + i % 9) % 2 == 0 ? PointStatus::kFell : PointStatus::kPass;
  }
  const std::vector<FailureGroup> groups = FailureGroups(sweep.study, sweep.outcomes);
  EXPECT_EQ(groups.size(), 4U);
  std::size_t points = 0;
  for (const FailureGroup& group : groups) points += group.points.size();
  EXPECT_EQ(points, 45U);
}

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
