// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tests/workflows/study/disturbed_walks.h"

namespace gaitwright {
namespace {

/// The first trials of the run in docs/sensing.md; a lower survival rate is a regression.
constexpr int kTrials = 60, kFallen = 1;

void ExpectToSurvive(const std::string& robot, const WalkRequest& walk, const std::string& disturbances) {
  const RobustnessReport tried = TriedByHobbySensors(robot, walk, disturbances, kTrials, 1);
  ASSERT_EQ(tried.n, kTrials);
  int fallen = 0;
  for (const TrialOutcome& outcome : tried.outcomes) {
    if (outcome.survived) continue;
    ++fallen;
    EXPECT_LE(fallen, kFallen) << "seed " << outcome.seed << ": " << outcome.reason;
  }
}

TEST(DisturbedWalksLong, AnA1TrotsOnASmallBudget) {
  WalkRequest walk;
  walk.command.speed_m_s = 0.3;
  walk.command.distance_m = 5.0;
  ExpectToSurvive("a1", walk, "a1_hobby.yaml");
}

TEST(DisturbedWalksLong, ANaoWalksAboutARoom) {
  WalkRequest walk;
  walk.command.extent = WalkCommand::Extent::kSteps;
  walk.command.steps = 20;
  walk.command.step_length_m = 0.04;
  ExpectToSurvive("nao", walk, "nao_room.yaml");
}

}  // namespace
}  // namespace gaitwright
