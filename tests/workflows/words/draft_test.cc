// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/words/draft.h"

#include <gtest/gtest.h>

namespace gaitwright::words {
namespace {

const std::string kDraftText = "walk left forward two metres three";

Span SpanIn(const std::string& words) {
  const std::size_t begin = kDraftText.find(words);
  return {begin, begin + words.size()};
}

Draft DraftOf(const std::string& action) {
  Draft draft;
  draft.action = action;
  draft.words = {0, kDraftText.size()};
  return draft;
}

void SaySide(const std::string& side, const std::string& words, Draft& draft) {
  draft.side = side;
  draft.side_said = SpanIn(words);
}

void Say(const std::string& key, TaskValue value, const std::string& words, Draft& draft) {
  draft.parameters[key] = std::move(value);
  draft.said[key] = SpanIn(words);
}

/// The refusal of a call; one without words if none is thrown.
template <class Call>
Refusal RefusalOf(Call call) {
  try {
    call();
  } catch (const Refused& refused) {
    return refused.refusal;
  }
  ADD_FAILURE() << "nothing was refused";
  return {};
}

std::string WordOf(const Draft& draft, const std::string& key) {
  return std::get<std::string>(draft.parameters.at(key));
}

TEST(Drafts, AParameterThatIsOnlyMeantIsSaidByAllOfTheWords) {
  Draft draft = DraftOf("walk");
  Say("distance_m", 2.0, "two metres", draft);
  draft.parameters["pace"] = std::string("slow");
  EXPECT_EQ(TextOf(kDraftText, SpanOf(draft, "distance_m")), "two metres");
  EXPECT_EQ(TextOf(kDraftText, SpanOf(draft, "pace")), kDraftText);
}

TEST(Drafts, ASideIsTheDirectionOfAWalkAndTheLimbOfAGesture) {
  Draft walk = DraftOf("walk");
  SaySide("left", "left", walk);
  SettleSide(kDraftText, walk);
  EXPECT_EQ(WordOf(walk, "direction"), "left");
  EXPECT_EQ(TextOf(kDraftText, SpanOf(walk, "direction")), "left");
  EXPECT_FALSE(walk.side);
  Draft balance = DraftOf("balance");
  SaySide("left", "left", balance);
  SettleSide(kDraftText, balance);
  EXPECT_EQ(WordOf(balance, "side"), "left");
  EXPECT_FALSE(balance.parameters.contains("direction"));
  Draft nod = DraftOf("nod");
  SaySide("left", "left", nod);
  SettleSide(kDraftText, nod);
  EXPECT_TRUE(nod.side) << "stays, and is refused later";
  EXPECT_TRUE(nod.parameters.empty());
}

TEST(Drafts, LimbsInThePluralAreBothUnlessASideIsSaid) {
  Draft both = DraftOf("wave");
  both.plural = true;
  SettleSide(kDraftText, both);
  EXPECT_EQ(WordOf(both, "side"), "both");
  Draft one = DraftOf("wave");
  one.plural = true;
  one.side = "right";  // without words in the text, so it is not a direction
  SettleSide(kDraftText, one);
  EXPECT_EQ(WordOf(one, "side"), "right");
  EXPECT_FALSE(one.plural);
}

TEST(Drafts, TwoDirectionsAtOnceAreAmbiguousExceptForATurn) {
  Draft walk = DraftOf("walk");
  Say("direction", std::string("forward"), "forward", walk);
  SaySide("left", "left", walk);
  const Refusal refusal = RefusalOf([&] { SettleSide(kDraftText, walk); });
  EXPECT_EQ(refusal.code, FailureCode::kAmbiguous);
  EXPECT_EQ(refusal.part, "left forward") << "from the first of the two to the last";
  Draft turn = DraftOf("turn");
  Say("direction", std::string("forward"), "forward", turn);
  SaySide("left", "left", turn);
  EXPECT_NO_THROW(SettleSide(kDraftText, turn));
  EXPECT_EQ(WordOf(turn, "direction"), "left");
}

TEST(Drafts, MergingAddsWhatIsNewAndRefusesWhatDiffers) {
  Draft into = DraftOf("walk"), said, other;
  Say("distance_m", 2.0, "two metres", said);
  Merge(kDraftText, said, false, into);
  EXPECT_EQ(std::get<double>(into.parameters.at("distance_m")), 2.0);
  EXPECT_NO_THROW(Merge(kDraftText, said, false, into)) << "the same twice";
  Say("distance_m", 3.0, "three", other);
  const Refusal refusal = RefusalOf([&] { Merge(kDraftText, other, false, into); });
  EXPECT_EQ(refusal.code, FailureCode::kAmbiguous);
  EXPECT_EQ(refusal.part, "two metres three");
}

TEST(Drafts, WhatCorrectsTakesThePlaceOfEveryExtent) {
  Draft into = DraftOf("walk"), said;
  Say("steps", 4, "forward", into);
  Say("pace", std::string("slow"), "left", into);
  Say("distance_m", 2.0, "two metres", said);
  Merge(kDraftText, said, true, into);
  EXPECT_FALSE(into.parameters.contains("steps"));
  EXPECT_FALSE(into.said.contains("steps"));
  EXPECT_EQ(std::get<double>(into.parameters.at("distance_m")), 2.0);
  EXPECT_EQ(WordOf(into, "pace"), "slow") << "is no extent";
}

TEST(Drafts, TheDistanceOfASquatIsItsDepth) {
  Draft into = DraftOf("squat"), said;
  Say("distance_m", 0.1, "two metres", said);
  Merge(kDraftText, said, false, into);
  EXPECT_EQ(std::get<double>(into.parameters.at("depth_m")), 0.1);
  EXPECT_FALSE(into.parameters.contains("distance_m"));
}

TEST(Drafts, ABareNumberThatCorrectsHasTheUnitOfTheLastAmount) {
  Draft into = DraftOf("walk"), said;
  Say("distance_m", 0.5, "two metres", into);
  into.last_key = "distance_m";
  into.last_unit = 0.01;
  said.bare.emplace();
  said.bare->value = 60.0;
  Merge(kDraftText, said, true, into);
  EXPECT_DOUBLE_EQ(std::get<double>(into.parameters.at("distance_m")), 0.6);
  Draft times = DraftOf("nod");
  Say("times", 2, "two metres", times);
  times.last_key = "times";
  said.bare->value = 3.0;
  Merge(kDraftText, said, true, times);
  EXPECT_EQ(times.parameters.at("times"), TaskValue(3)) << "a count stays whole";
  Draft fresh = DraftOf("walk");
  Merge(kDraftText, said, true, fresh);
  EXPECT_TRUE(fresh.bare) << "no amount gives it a unit";
}

TEST(Drafts, APartOfTheBodyThatTheActionDoesNotUseIsRefused) {
  Draft into = DraftOf("walk"), said;
  said.part = "arm";
  said.words = SpanIn("left");
  const Refusal refusal = RefusalOf([&] { Merge(kDraftText, said, false, into); });
  EXPECT_EQ(refusal.code, FailureCode::kUnknown);
  EXPECT_EQ(refusal.part, "left");
  EXPECT_TRUE(IsDoneWith("wave", "arm"));
  EXPECT_FALSE(IsDoneWith("wave", "foot"));
  EXPECT_TRUE(IsDoneWith("", "foot")) << "of an arm or a foot alone no action need be said";
  EXPECT_FALSE(IsDoneWith("", "head"));
}

}  // namespace
}  // namespace gaitwright::words
