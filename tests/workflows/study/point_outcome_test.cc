// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/point_outcome.h"

#include <gtest/gtest.h>

namespace gaitwright {
namespace {

PointOutcome At(std::size_t point, PointStatus status, std::optional<double> score) {
  PointOutcome outcome;
  outcome.point = point;
  outcome.status = status;
  outcome.score = score;
  return outcome;
}

TEST(PointOutcome, ALineReadsBackToTheBit) {
  PointOutcome outcome = At(17, PointStatus::kFell, 1.0 / 3.0);
  outcome.code = "fell";
  outcome.reason = "it \"fell\"\nat 1.2 s, schräg";
  outcome.fell_at_s = 0.1 + 0.2;
  outcome.metrics = {1e-300, std::nullopt, -0.1};
  outcome.survival = SurvivalOf(7, 3, 2.0 / 7.0);
  const std::string line = PointToLine(outcome);
  EXPECT_EQ(line.find('\n'), std::string::npos);
  const Result<PointOutcome> read = PointFromLine(line);
  ASSERT_TRUE(read) << read.failure().message;
  EXPECT_EQ(*read, outcome);
  outcome.engines = {{"bullet", true, false, 200.0 / 3.0, ""}, {"mujoco", false, true, 1.0 / 3.0, "slipped"}};
  EXPECT_EQ(*PointFromLine(PointToLine(outcome)), outcome);
  const PointOutcome refused = At(3, PointStatus::kRefused, std::nullopt);
  EXPECT_EQ(*PointFromLine(PointToLine(refused)), refused);
}

TEST(PointOutcome, BrokenLinesAreFailures) {
  for (const char* line : {"", "{}", "{\"point\":1", "[1,2]", "{\"point\":1,\"status\":\"odd\"}"}) {
    const Result<PointOutcome> read = PointFromLine(line);
    ASSERT_FALSE(read) << line;
    EXPECT_EQ(read.failure().code, FailureCode::kJournalLine);
  }
  PointOutcome outcome = At(4, PointStatus::kPass, 90.0);
  for (const auto& [trials, survived] : {std::pair{0, 0}, {5, 6}, {-3, -5}}) {
    outcome.survival = PointSurvival{trials, survived, 0.5, 0.2, 0.8, 90.0};
    EXPECT_FALSE(PointFromLine(PointToLine(outcome))) << survived << " of " << trials;
  }
  outcome.survival = SurvivalOf(10, 6, 70.0);
  outcome.survival->low = 0.59;
  EXPECT_FALSE(PointFromLine(PointToLine(outcome))) << "an interval that its trials do not give";
}

TEST(PointOutcome, TheBestIsChosenBySurvivalThenVerdictThenScoreThenNumber) {
  PointOutcome a = At(4, PointStatus::kPass, 90.0), b = At(2, PointStatus::kPass, 80.0);
  EXPECT_TRUE(IsBetter(a, b)) << "by score";
  a.survival = SurvivalOf(10, 6, 70.0);
  b.survival = SurvivalOf(10, 7, 60.0);
  EXPECT_TRUE(IsBetter(b, a)) << "survival comes before the score";
  b.survival = a.survival;
  b.status = PointStatus::kGateMissed;
  b.score = 99.0;
  EXPECT_TRUE(IsBetter(a, b)) << "a pass comes before the score";
  b = a;
  b.point = 2;
  EXPECT_TRUE(IsBetter(b, a)) << "the first of equals";
  EXPECT_FALSE(IsBetter(a, b));
  EXPECT_FALSE(IsBetter(a, a));
}

TEST(PointOutcome, APlanThatFailsItsAuditIsNeverBetterThanOneThatPasses) {
  PointOutcome fell = At(1, PointStatus::kFell, 3.0), unsound = At(0, PointStatus::kAuditFailed, 95.0);
  EXPECT_TRUE(IsBetter(fell, unsound));
  EXPECT_FALSE(IsBetter(unsound, fell));
}

TEST(PointOutcome, SurvivalHasWilsonsInterval) {
  const PointSurvival s = SurvivalOf(10, 5, 0.0);
  EXPECT_NEAR(s.low, 0.2366, 1e-4);
  EXPECT_NEAR(s.high, 0.7634, 1e-4);
}

}  // namespace
}  // namespace gaitwright
