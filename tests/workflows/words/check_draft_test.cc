// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/words/check_draft.h"

#include <gtest/gtest.h>

#include <optional>

namespace gaitwright::words {
namespace {

const std::string kCheckedText = "do it left 90 to the door";

Span CheckedSpan(const std::string& words) {
  const std::size_t begin = kCheckedText.find(words);
  return {begin, begin + words.size()};
}

TaskScope BipedScope() {
  TaskScope scope;
  scope.robot = "biped";
  scope.left_arm = scope.right_arm = scope.head = scope.two_soles = scope.turning_feet = true;
  scope.places = {{"door", 0}};
  return scope;
}

/// A task and its draft, with words for each parameter.
struct Checked {
  Task task;
  Draft draft;

  explicit Checked(const std::string& action) {
    task.action = draft.action = action;
    draft.words = {0, kCheckedText.size()};
  }
  Checked& Say(const std::string& key, const TaskValue& value, const std::string& words) {
    task.parameters[key] = draft.parameters[key] = value;
    draft.said[key] = CheckedSpan(words);
    return *this;
  }
  /// The refusal; nothing if the draft is accepted.
  std::optional<Refusal> Refused(const TaskScope& scope = BipedScope()) const {
    try {
      CheckDraft(kCheckedText, scope, task, draft);
    } catch (const words::Refused& refused) {
      return refused.refusal;
    }
    return std::nullopt;
  }
};

void ExpectRefusal(const Checked& checked, FailureCode code, const std::string& part) {
  const std::optional<Refusal> refusal = checked.Refused();
  ASSERT_TRUE(refusal) << part;
  EXPECT_EQ(refusal->code, code) << refusal->why;
  EXPECT_EQ(refusal->part, part) << refusal->why;
}

TEST(CheckDraft, ActionsTakeTheirOwnParametersOnly) {
  EXPECT_TRUE(Takes("walk", "distance_m"));
  EXPECT_TRUE(Takes("turn", "angle_deg"));
  EXPECT_FALSE(Takes("turn", "to"));
  EXPECT_FALSE(Takes("nod", "distance_m"));
  for (const ActionRule& rule : ActionRules()) {
    for (const std::string& key : rule.required) EXPECT_TRUE(Takes(rule.action, key)) << rule.action << key;
  }
}

TEST(CheckDraft, ATaskThatIsWholeIsAccepted) {
  EXPECT_FALSE(Checked("nod").Refused());
  EXPECT_FALSE(Checked("turn").Say("direction", std::string("left"), "left").Say("angle_deg", 90.0, "90").Refused());
  EXPECT_FALSE(Checked("walk")
                   .Say("direction", std::string("forward"), "do it")
                   .Say("to", PlaceName{"door", 0}, "the door")
                   .Refused());
}

TEST(CheckDraft, ANumberWithoutAUnitIsAskedFor) {
  Checked turn("turn");
  turn.Say("direction", std::string("left"), "left");
  Item number;
  number.begin = CheckedSpan("90").begin;
  number.end = CheckedSpan("90").end;
  turn.draft.bare = number;
  ExpectRefusal(turn, FailureCode::kAmbiguous, "90");
}

TEST(CheckDraft, WhatAnActionDoesNotTakeIsRefusedByItsWords) {
  ExpectRefusal(Checked("nod").Say("angle_deg", 90.0, "90"), FailureCode::kUnknown, "90");
  ExpectRefusal(Checked("nod").Say("to", PlaceName{"door", 0}, "the door"), FailureCode::kUnknown, "the door");
}

TEST(CheckDraft, ValuesOutOfRangeAndUnknownPlacesAreRefusedByTheirWords) {
  ExpectRefusal(Checked("nod").Say("times", 1000, "90"), FailureCode::kRange, "90");
  ExpectRefusal(
      Checked("walk").Say("direction", std::string("forward"), "do it").Say("to", PlaceName{"kitchen", 0}, "the door"),
      FailureCode::kPlace, "the door");
}

TEST(CheckDraft, ADistanceIsSaidOnce) {
  ExpectRefusal(Checked("walk")
                    .Say("direction", std::string("forward"), "do it")
                    .Say("distance_m", 1.0, "90")
                    .Say("to", PlaceName{"door", 0}, "the door"),
                FailureCode::kAmbiguous, "90 to the door");
}

TEST(CheckDraft, WhatIsMissingIsAskedFor) {
  const Checked turn("turn");
  ExpectRefusal(turn, FailureCode::kAmbiguous, kCheckedText);
  EXPECT_EQ(turn.Refused()->say, "left or right");
  Checked nowhere("walk");
  nowhere.Say("direction", std::string("forward"), "do it");
  nowhere.draft.to_nowhere = true;
  ExpectRefusal(nowhere, FailureCode::kPlace, kCheckedText);
}

TEST(CheckDraft, ASideIsNothingToWhatHasNone) {
  Checked nod("nod");
  nod.draft.side = "left";
  nod.draft.side_said = CheckedSpan("left");
  ExpectRefusal(nod, FailureCode::kUnknown, "left");
}

TEST(CheckDraft, SidewaysNeedsASide) {
  Checked walk("walk");
  walk.Say("direction", std::string("forward"), "do it");
  walk.draft.sideways = CheckedSpan("do it");
  ExpectRefusal(walk, FailureCode::kAmbiguous, "do it");
  walk.Say("direction", std::string("left"), "left");
  EXPECT_FALSE(walk.Refused());
}

TEST(CheckDraft, WhatTheRobotCannotDoNamesWhatItCan) {
  TaskScope scope = BipedScope();
  scope.left_arm = scope.right_arm = false;
  const std::optional<Refusal> refusal = Checked("wave").Refused(scope);
  ASSERT_TRUE(refusal);
  EXPECT_EQ(refusal->code, FailureCode::kCannot);
  EXPECT_EQ(refusal->nearest, FindAction("wave")->instead);
}

TEST(CheckDraft, WhatIsDoneMeanwhileIsCheckedToo) {
  Checked walk("walk");
  walk.Say("direction", std::string("forward"), "do it").Say("distance_m", 1.0, "90");
  const Checked nod = Checked("nod").Say("times", 1000, "left");
  walk.task.during = {nod.task};
  walk.draft.during = {nod.draft};
  ExpectRefusal(walk, FailureCode::kRange, "left");
}

}  // namespace
}  // namespace gaitwright::words
