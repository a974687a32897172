// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/walk/engine_verdict.h"

#include <gtest/gtest.h>

namespace gaitwright {
namespace {

/// A playback with the given verdict in the given engine.
ScoredPlayback MadeUpPlayback(const std::string& engine, bool pass, bool fell, double score) {
  ScoredPlayback played;
  played.log.options = {{"play.engine", engine}};
  Metric metric;
  metric.key = "fell";
  metric.value = fell ? 1.0 : 0.0;
  played.report.metrics = {metric};
  played.report.pass = pass;
  played.report.score = score;
  played.report.cause = pass ? "" : "FL_calf: torque limit";
  return played;
}

PlayedWalk InTwoEngines(const ScoredPlayback& first, const ScoredPlayback& second) {
  PlayedWalk played{first};
  auto other = std::make_shared<SecondPlayback>();
  static_cast<ScoredPlayback&>(*other) = second;
  played.second = other;
  return played;
}

TEST(VerdictsOfPlayedWalk, OneEngineHasNoneToSetSideBySide) {
  EXPECT_TRUE(VerdictsOf(PlayedWalk{MadeUpPlayback("bullet", true, false, 90.0)}).empty());
}

TEST(VerdictsOfPlayedWalk, TwoEnginesAreInTheOrderOfPlaying) {
  const auto verdicts = VerdictsOf(
      InTwoEngines(MadeUpPlayback("bullet", true, false, 91.25), MadeUpPlayback("mujoco", false, true, 40.0)));
  const std::vector<EngineVerdict> expected = {{"bullet", true, false, 91.25, ""},
                                               {"mujoco", false, true, 40.0, "FL_calf: torque limit"}};
  EXPECT_EQ(verdicts, expected);
}

TEST(VerdictName, AFallIsNamedBeforeAGateThatFails) {
  EXPECT_EQ(VerdictName({"bullet", true, false, 90.0, ""}), "pass");
  EXPECT_EQ(VerdictName({"bullet", false, false, 60.0, ""}), "fail");
  EXPECT_EQ(VerdictName({"bullet", false, true, 20.0, ""}), "fell");
}

TEST(VerdictsText, HasTitleVerdictAndScoreOfEachEngine) {
  EXPECT_EQ(VerdictsText({{"bullet", true, false, 91.25, ""}, {"mujoco", false, true, 40.0, ""}}),
            "Bullet: pass, 91.2; MuJoCo: fell, 40.0");
  EXPECT_EQ(VerdictsText({}), "");
}

}  // namespace
}  // namespace gaitwright
