// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/sweep.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/workflows/study/made_up_sweep.h"
#include "workflows/study/sweep_files.h"

namespace gaitwright {
namespace {

using Json = nlohmann::ordered_json;

const std::vector<std::string> kFiveSpeeds = {"speed=0.3:0.7:5", "play.push_on=base,robot"};

TEST(SweepSummary, CountsEachStatusAndFindsTheBest) {
  const MadeUpSweep sweep = MakeUpSweep(kFiveSpeeds);
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
  MadeUpSweep sweep = MakeUpSweep(kFiveSpeeds, 4);
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

TEST(FailureGroups, EveryPointThatDidNotPassIsInOneOfThem) {
  const MadeUpSweep sweep = MakeUpSweep({"speed=0.1:1:10", "play.push_on=base,robot", "play.friction=0.4,0.8"});
  std::vector<int> seen(sweep.outcomes.size(), 0);
  for (const FailureGroup& group : FailureGroups(sweep.study, sweep.outcomes)) {
    for (const std::size_t point : group.points) {
      ++seen[point];
      EXPECT_EQ(sweep.outcomes[point].status, group.status);
      EXPECT_EQ(sweep.outcomes[point].code, group.code);
    }
  }
  for (std::size_t point = 0; point < seen.size(); ++point)
    EXPECT_EQ(seen[point], sweep.outcomes[point].status == PointStatus::kPass ? 0 : 1) << point;
}

TEST(FailureGroups, WhereAllPassThereAreNone) {
  const MadeUpSweep sweep = MakeUpSweep({"speed=0.1,0.2"});
  EXPECT_TRUE(FailureGroups(sweep.study, sweep.outcomes).empty());
  EXPECT_TRUE(FailureGroups(sweep.study, {}).empty());
  EXPECT_FALSE(SummaryOf({}).best);
}

}  // namespace
}  // namespace gaitwright
