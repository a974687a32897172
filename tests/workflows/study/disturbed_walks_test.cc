// SPDX-License-Identifier: BSD-3-Clause
#include "tests/workflows/study/disturbed_walks.h"

#include <gtest/gtest.h>

namespace gaitwright {
namespace {

/// On an unknown slope the estimated state has an error of the slope angle, so a NAO leans, and the weight of its legs
/// acts differently from the plan. A controller that compensated all of this weight lost its contribution to balance,
/// and the robot fell.
TEST(DisturbedWalks, ANaoOnAnUnknownSlopeStandsByTheWeightOfItsLegs) {
  WalkRequest walk;
  walk.command.extent = WalkCommand::Extent::kSteps;
  walk.command.steps = 6;
  walk.command.step_length_m = 0.04;
  const RobustnessReport tried = TriedByHobbySensors("nao", walk, "nao_room.yaml", 2, 29);
  for (const TrialOutcome& outcome : tried.outcomes) EXPECT_TRUE(outcome.survived) << outcome.reason;
}

}  // namespace
}  // namespace gaitwright
