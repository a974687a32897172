// SPDX-License-Identifier: BSD-3-Clause
// Walks up and down stairs of three steps, in sequences of tasks.
#include <gtest/gtest.h>

#include "workflows/words/climb.h"
#include "workflows/words/places.h"

namespace gaitwright::words {
namespace {

const std::string kStairsText = "climb the stairs";

/// The ground before the stairs, three steps up, two down, and the ground behind them.
const std::vector<PlaceName> kStairsUpAndDown = {
    {kStartOfStairs, 0}, {"step", 3}, {"step 1 down", 0}, {"step 2 down", 0}, {kEndOfStairs, 0}};
const std::vector<PlaceName> kStairsUpAlone = {{kStartOfStairs, 0}, {"step", 3}};

/// A walk on stairs: 1 up, -1 down, 2 to the next step; to the end, or a number of steps.
Draft StairsWalk(int stairs, int steps = 0) {
  Draft draft;
  draft.action = "walk";
  draft.stairs = stairs;
  draft.words = {0, kStairsText.size()};
  if (steps > 0) {
    draft.parameters["steps"] = steps;
    draft.said["steps"] = draft.words;
  } else {
    draft.parameters["to"] = PlaceName{kStairs, 0};
  }
  return draft;
}

Draft TurnBy(double angle_deg, const std::string& direction = "left") {
  Draft draft;
  draft.action = "turn";
  draft.parameters["angle_deg"] = angle_deg;
  draft.parameters["direction"] = direction;
  return draft;
}

/// The places where the walks end.
std::vector<PlaceName> EndsOf(std::vector<Draft> drafts, const std::vector<PlaceName>& places) {
  SettleStairs(kStairsText, places, drafts);
  std::vector<PlaceName> ends;
  for (const Draft& draft : drafts) {
    const auto to = draft.parameters.find("to");
    if (to != draft.parameters.end()) ends.push_back(std::get<PlaceName>(to->second));
  }
  return ends;
}

FailureCode CodeOfStairs(std::vector<Draft> drafts, const std::vector<PlaceName>& places) {
  try {
    SettleStairs(kStairsText, places, drafts);
  } catch (const Refused& refused) {
    EXPECT_EQ(refused.refusal.part, kStairsText);
    return refused.refusal.code;
  }
  ADD_FAILURE() << "nothing was refused";
  return FailureCode::kInternal;
}

using Ends = std::vector<PlaceName>;

TEST(SettleStairs, UpEndsAtTheTopAndDownBehindThem) {
  EXPECT_EQ(EndsOf({StairsWalk(1)}, kStairsUpAndDown), (Ends{{"step", 3}}));
  EXPECT_EQ(EndsOf({StairsWalk(1), StairsWalk(-1)}, kStairsUpAndDown), (Ends{{"step", 3}, {kEndOfStairs, 0}}));
}

TEST(SettleStairs, StepsAreCountedFromWhereTheWalkBeforeEnds) {
  EXPECT_EQ(EndsOf({StairsWalk(1, 2), StairsWalk(1, 1), StairsWalk(-1, 1)}, kStairsUpAndDown),
            (Ends{{"step", 2}, {"step", 3}, {"step 1 down", 0}}));
  EXPECT_EQ(EndsOf({StairsWalk(1, 2), StairsWalk(-1, 1)}, kStairsUpAndDown), (Ends{{"step", 2}, {"step", 1}}))
      << "below the top down is back";
  EXPECT_EQ(EndsOf({StairsWalk(2, 1), StairsWalk(2, 1)}, kStairsUpAndDown), (Ends{{"step", 1}, {"step", 2}}));
}

TEST(SettleStairs, AtTheTopDownIsWhereTheRobotFaces) {
  EXPECT_EQ(EndsOf({StairsWalk(1), TurnBy(180.0), StairsWalk(-1)}, kStairsUpAndDown),
            (Ends{{"step", 3}, {kStartOfStairs, 0}}));
  EXPECT_EQ(EndsOf({StairsWalk(1), TurnBy(90.0), TurnBy(90.0, "right"), StairsWalk(-1)}, kStairsUpAndDown),
            (Ends{{"step", 3}, {kEndOfStairs, 0}}));
  EXPECT_EQ(CodeOfStairs({StairsWalk(1), TurnBy(90.0), StairsWalk(-1)}, kStairsUpAndDown), FailureCode::kAmbiguous);
}

TEST(SettleStairs, StairsThatGoUpAloneAreGoneDownBackwards) {
  EXPECT_EQ(EndsOf({StairsWalk(1), StairsWalk(-1)}, kStairsUpAlone), (Ends{{"step", 3}, {kStartOfStairs, 0}}));
}

TEST(SettleStairs, WhatTheStairsDoNotHaveIsRefused) {
  EXPECT_EQ(CodeOfStairs({StairsWalk(1)}, {{"door", 0}}), FailureCode::kPlace) << "no stairs";
  EXPECT_EQ(CodeOfStairs({StairsWalk(1, 4)}, kStairsUpAndDown), FailureCode::kRange) << "more steps than there are";
  EXPECT_EQ(CodeOfStairs({StairsWalk(-1)}, kStairsUpAndDown), FailureCode::kCannot) << "down from the ground";
  EXPECT_EQ(CodeOfStairs({StairsWalk(1), StairsWalk(1)}, kStairsUpAndDown), FailureCode::kCannot) << "up from the top";
}

/// A place given with "up" or "down" must be above or below the robot.
TEST(SettleStairs, APlaceThatIsSaidIsUpOrDownFromThere) {
  const auto to = [](int stairs, int step) {
    Draft draft = StairsWalk(stairs);
    draft.parameters["to"] = PlaceName{"step", step};
    return draft;
  };
  EXPECT_EQ(EndsOf({StairsWalk(1), to(-1, 1)}, kStairsUpAndDown), (Ends{{"step", 3}, {"step", 1}}));
  EXPECT_EQ(CodeOfStairs({StairsWalk(1), to(1, 2)}, kStairsUpAndDown), FailureCode::kCannot);
  EXPECT_EQ(CodeOfStairs({StairsWalk(1, 1), to(-1, 3)}, kStairsUpAndDown), FailureCode::kCannot);
}

/// After a walk to another place, the robot's step is unknown.
TEST(SettleStairs, FromElsewhereOnlyTheWholeClimbIsKnown) {
  Draft away;
  away.action = "walk";
  away.parameters["distance_m"] = 1.0;
  EXPECT_EQ(EndsOf({away, StairsWalk(1)}, kStairsUpAndDown), (Ends{{"step", 3}}));
  EXPECT_EQ(CodeOfStairs({away, StairsWalk(1, 1)}, kStairsUpAndDown), FailureCode::kAmbiguous);
  EXPECT_EQ(CodeOfStairs({away, StairsWalk(-1)}, kStairsUpAndDown), FailureCode::kAmbiguous);
}

}  // namespace
}  // namespace gaitwright::words
