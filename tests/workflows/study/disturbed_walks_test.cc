// SPDX-License-Identifier: BSD-3-Clause
#include "tests/workflows/study/disturbed_walks.h"

#include <gtest/gtest.h>

namespace gaitwright {
namespace {

/// On a slope that it does not know of, with a state that is as far off as the slope, a NAO leans and its legs weigh
/// otherwise than planned. To bear all of that took from its balance what the legs' weight gives it, and it fell.
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
