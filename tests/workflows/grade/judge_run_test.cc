// SPDX-License-Identifier: BSD-3-Clause
// Marks of runs with synthetic outcomes, and refusals before playback.
#include <gtest/gtest.h>

#include "kinematics/model/load_robot.h"
#include "tests/playback/standing_plan.h"
#include "workflows/grade/motion_run.h"

namespace gaitwright {
namespace {

/// Half of the points for survival, half for the audit.
RubricPart JudgedPart() {
  RubricPart part;
  part.name = part.title = "walks";
  part.kind = RubricPartKind::kPlan;
  part.points = 4.0;
  Check survival, audit;
  survival.measure = "survival";
  survival.points = 2.0;
  survival.none_at = 0.0;
  audit.measure = "audit";
  audit.points = 2.0;
  audit.none_at = 0.0;
  part.checks = {survival, audit};
  return part;
}

RunOutcome Judged(const std::string& title, bool audit, int survived, int trials) {
  RunOutcome run;
  run.title = title;
  run.audit_passes = audit;
  run.audit_words = "reach at 1.00 s";
  run.survived = survived;
  run.trials = trials;
  return run;
}

TEST(MarkOfRuns, AllPointsNeedNoReason) {
  const PartMark mark = MarkOfRuns(JudgedPart(), {Judged("a", true, 3, 3)}, {{"page", "<html>"}});
  EXPECT_EQ(mark.points, 4.0);
  EXPECT_TRUE(mark.reasons.empty());
  ASSERT_EQ(mark.pages.size(), 1U);
  EXPECT_EQ(mark.pages[0].title, "page");
}

// 3 of 4 trials survived, and 1 of 2 runs passes its audit.
TEST(MarkOfRuns, SharesAreOverAllRunsAndTheirTrials) {
  const PartMark mark = MarkOfRuns(JudgedPart(), {Judged("a", true, 2, 2), Judged("b", false, 1, 2)}, {});
  ASSERT_EQ(mark.checks.size(), 2U);
  EXPECT_NEAR(mark.checks[0].value.value(), 0.75, 1e-12);
  EXPECT_NEAR(mark.checks[0].points, 1.5, 1e-12);
  EXPECT_NEAR(mark.checks[1].value.value(), 0.5, 1e-12);
  EXPECT_NEAR(mark.points, 2.5, 1e-12);
}

TEST(MarkOfRuns, ReasonsNameTheRunAndAreSixAtMost) {
  const auto with = [](const std::vector<RunOutcome>& runs) { return MarkOfRuns(JudgedPart(), runs, {}).reasons; };
  const auto named = [](const std::vector<std::string>& reasons, const std::string& begin) {
    int count = 0;
    for (const std::string& reason : reasons) count += reason.starts_with(begin) ? 1 : 0;
    return count;
  };
  RunOutcome failed = Judged("run 2", false, 0, 2);
  failed.failure = "the motion lasts too long";
  const auto reasons = with({Judged("run 1", false, 1, 2), failed});
  EXPECT_EQ(named(reasons, "run 1: the audit fails: reach at 1.00 s"), 1);
  EXPECT_EQ(named(reasons, "run 1: 1 of 2 trials survived"), 1);
  EXPECT_EQ(named(reasons, "run 2: "), 1) << "where there is no motion, only that";
  EXPECT_EQ(named(reasons, "run 2: the motion lasts too long"), 1);
  EXPECT_EQ(named(with(std::vector<RunOutcome>(20, Judged("run", false, 0, 2))), "run: "), 6);
}

TEST(JudgeRun, AMotionThatLastsTooLongIsNotPlayed) {
  const RobotModel model = standing::Load("a1");
  const MotionPlan plan = standing::Plan(model, 2.5);
  RubricPart part = JudgedPart();
  part.motion.longest_motion_s = 2.0;
  part.motion.trials = 3;
  MotionRun run;
  run.title = "run 1: flat";
  std::vector<MotionPage> pages;
  const RunOutcome outcome = JudgeRun({part, model}, run, plan, pages);
  EXPECT_EQ(outcome.title, "run 1: flat");
  EXPECT_EQ(outcome.trials, 3);
  EXPECT_NE(outcome.failure.find("lasts 2.5 s; at most 2 s"), std::string::npos) << outcome.failure;
  EXPECT_FALSE(outcome.report);
  EXPECT_TRUE(pages.empty());
}

}  // namespace
}  // namespace gaitwright
