// SPDX-License-Identifier: BSD-3-Clause
// Sharing of plans between points, with a walk that is refused before planning.
#include "workflows/study/run_point.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/playback/synthetic.h"

namespace gaitwright {
namespace {

/// Points over a speed, which affects the plan, and a friction of the playback, which does not.
Study SharingStudy() {
  Study study;
  study.model = synthetic::Robot(2, FootType::kSole);
  study.walk.gait = "no-such-gait";
  study.axes = ParseAxes({"play.friction=0.4,0.6,0.8", "speed=0.1,0.2"}, StudyLayout::kGrid);
  study.points = GridPoints(study.axes);
  return study;
}

TEST(RunPointPlans, KeysAreEqualWherePlansAre) {
  const Study study = SharingStudy();
  for (const StudyPoint& a : study.points) {
    for (const StudyPoint& b : study.points)
      EXPECT_EQ(PlanKey(study.axes, a) == PlanKey(study.axes, b), a[1] == b[1]) << a[0] << b[0];
  }
  const auto axes = ParseAxes({"speed=1,12", "yaw_rate=12,2"}, StudyLayout::kGrid);
  EXPECT_NE(PlanKey(axes, {"1", "12"}), PlanKey(axes, {"12", "2"})) << "values do not run into each other";
}

TEST(RunPointPlans, PointsThatShareAPlanAreConsecutiveAndElseInOrder) {
  const Study study = SharingStudy();
  const std::vector<std::size_t> ordered = OrderByPlan(study, {5, 0, 1, 2, 3, 4});
  std::vector<std::string> keys;
  for (const std::size_t point : ordered) {
    const std::string key = PlanKey(study.axes, study.points[point]);
    if (keys.empty() || keys.back() != key) keys.push_back(key);
  }
  EXPECT_EQ(keys.size(), 2U);
  EXPECT_EQ(std::set<std::size_t>(ordered.begin(), ordered.end()).size(), 6U) << "none is lost";
  EXPECT_EQ(OrderByPlan(study, {0, 2, 4}), (std::vector<std::size_t>{0, 2, 4}));
  EXPECT_TRUE(OrderByPlan(study, {}).empty());
}

TEST(RunPointPlans, APlanIsMadeOnceForAllThatShareIt) {
  const Study study = SharingStudy();
  StudyPlans plans(study, {0, 1, 2, 3, 4, 5});
  EXPECT_EQ(plans.made(), 0);
  const StudyPlans::Shared first = plans.Take(0), other = plans.Take(1), again = plans.Take(2);
  EXPECT_EQ(plans.made(), 2);
  EXPECT_EQ(first, again);
  EXPECT_NE(first, other);
}

/// A plan is dropped after the last point has requested it.
TEST(RunPointPlans, APlanThatNobodyWaitsForIsDropped) {
  const Study study = SharingStudy();
  StudyPlans plans(study, {0, 2});
  const std::weak_ptr<const Result<PlannedWalk>> kept = plans.Take(0);
  EXPECT_FALSE(kept.expired()) << "another point waits for it";
  plans.Take(2);
  EXPECT_TRUE(kept.expired());
}

TEST(RunPointPlans, APointWhoseWalkIsRefusedHasTheReasonAndNoFigures) {
  Study study = SharingStudy();
  study.trials = 3;
  study.metrics = {"goal_error_m"};
  StudyPlans plans(study, {4});
  const PointOutcome outcome = RunPoint(study, 4, plans);
  EXPECT_EQ(outcome.point, 4U);
  EXPECT_EQ(outcome.status, PointStatus::kRefused);
  EXPECT_FALSE(outcome.code.empty());
  EXPECT_NE(outcome.reason.find("no-such-gait"), std::string::npos) << outcome.reason;
  EXPECT_FALSE(outcome.score || outcome.survival || outcome.fell_at_s);
  EXPECT_TRUE(outcome.metrics.empty());
}

TEST(RunPointPlans, ThePlaybackOfAPointHasItsValues) {
  const Study study = SharingStudy();
  PlayRequest play = PlaybackOf(study, {"0.6", "0.2"});
  const OptionFields fields = play.Fields();
  const auto friction =
      std::find_if(fields.begin(), fields.end(), [](const OptionField& field) { return field.key == "play.friction"; });
  ASSERT_NE(friction, fields.end());
  EXPECT_EQ(OptionText(*friction), "0.6");
  const Result<PlannedWalk> planned = PlanPoint(study, {"0.6", "0.2"});
  ASSERT_FALSE(planned.ok());
  EXPECT_EQ(planned.failure().kind, FailureKind::kBadInput);
}

}  // namespace
}  // namespace gaitwright
