// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/words/climb.h"

#include <gtest/gtest.h>

namespace gaitwright::words {
namespace {

using M = Meaning;

const std::string kClimbText = "climb the stairs two metres";

Item ClimbItem(M meaning, double value, const std::string& words) {
  Item item;
  item.meaning = meaning;
  item.value = value;
  item.begin = kClimbText.find(words);
  item.end = item.begin + words.size();
  return item;
}

Item ClimbVerb(double value, const std::string& words = "climb") {
  Item item = ClimbItem(M::kAction, value, words);
  item.name = "walk";
  return item;
}

Clause StairsClause(const std::vector<Item>& items) {
  Clause clause;
  clause.items = items;
  return clause;
}

/// The result of Settle for an empty draft, or for one with an action.
Draft Settled(const ClimbWords& words, const std::string& action = "") {
  Draft draft;
  draft.action = action;
  draft.words = {0, kClimbText.size()};
  words.Settle(kClimbText, draft);
  return draft;
}

template <class Call>
Refusal ClimbRefusal(Call call) {
  try {
    call();
  } catch (const Refused& refused) {
    return refused.refusal;
  }
  ADD_FAILURE() << "nothing was refused";
  return {};
}

TEST(ClimbWordsOfStairs, ClimbingTheStairsGoesToTheirEnd) {
  ClimbWords words;
  words.TakeVerb(ClimbVerb(kUpStairs));
  words.TakeStairs(kClimbText, StairsClause({ClimbVerb(kUpStairs), ClimbItem(M::kStairs, 0.0, "stairs")}), 1);
  EXPECT_TRUE(words.IsSure());
  const Draft draft = Settled(words);
  EXPECT_EQ(draft.action, "walk");
  EXPECT_EQ(draft.stairs, 1);
  EXPECT_EQ(std::get<PlaceName>(draft.parameters.at("to")).name, kStairs);
  EXPECT_EQ(TextOf(kClimbText, draft.said.at("to")), "stairs");
}

TEST(ClimbWordsOfStairs, DownIsTheOppositeDirection) {
  ClimbWords words;
  words.TakeVerb(ClimbVerb(kDownStairs));
  words.TakeTreads();
  EXPECT_EQ(Settled(words).stairs, -1);
  words.TakeDirection(1, ClimbItem(M::kUp, 0.0, "the"));
  EXPECT_EQ(Settled(words).stairs, -1) << "the verb has said it";
}

TEST(ClimbWordsOfStairs, GoingUpByADistanceIsNoClimb) {
  ClimbWords up;
  up.TakeVerb(ClimbVerb(kUpwards));
  EXPECT_FALSE(up.IsSure());
  Draft draft;
  draft.action = "walk";
  draft.parameters["distance_m"] = 2.0;
  draft.said["distance_m"] = {17, 27};
  up.Settle(kClimbText, draft);
  EXPECT_EQ(draft.stairs, 0);
  EXPECT_FALSE(draft.parameters.contains("to"));
}

TEST(ClimbWordsOfStairs, StairsAreNotGoneByMetres) {
  ClimbWords words;
  words.TakeVerb(ClimbVerb(kUpStairs));
  Draft draft;
  draft.action = "walk";
  draft.parameters["distance_m"] = 2.0;
  draft.said["distance_m"] = {17, 27};
  const Refusal refusal = ClimbRefusal([&] { words.Settle(kClimbText, draft); });
  EXPECT_EQ(refusal.code, FailureCode::kUnknown);
  EXPECT_EQ(refusal.part, "two metres");
}

TEST(ClimbWordsOfStairs, StairsWithoutADirectionAreRefused) {
  ClimbWords words;
  words.TakeStairs(kClimbText, StairsClause({ClimbItem(M::kStairs, 0.0, "stairs")}), 0);
  EXPECT_EQ(ClimbRefusal([&] { Settled(words, "walk"); }).part, "stairs");
  EXPECT_EQ(ClimbRefusal([&] { Settled(words, "nod"); }).part, "stairs") << "nothing to a nod";
}

TEST(ClimbWordsOfStairs, StairsAreNoPlaceToGoTo) {
  ClimbWords words;
  const Clause clause =
      StairsClause({ClimbVerb(0.0), ClimbItem(M::kTo, 0.0, "the"), ClimbItem(M::kStairs, 0.0, "stairs")});
  EXPECT_EQ(ClimbRefusal([&] { words.TakeStairs(kClimbText, clause, 2); }).code, FailureCode::kPlace);
}

TEST(ClimbWordsOfStairs, ANumberOfStepsStaysOne) {
  ClimbWords words;
  words.TakeVerb(ClimbVerb(kUpStairs));
  words.TakeTreads();
  Draft draft;
  draft.action = "walk";
  draft.parameters["steps"] = 2;
  draft.said["steps"] = {17, 20};
  words.Settle(kClimbText, draft);
  EXPECT_EQ(draft.stairs, 1);
  EXPECT_FALSE(draft.parameters.contains("to"));
}

TEST(ClimbWordsOfStairs, GoingOnIsOneMoreWalkOnThem) {
  Draft last, said;
  last.stairs = 1;
  said.stairs = -1;
  said.words = {0, 5};
  GoOnStairs(last, said);
  EXPECT_EQ(said.action, "walk");
  EXPECT_TRUE(said.parameters.contains("to"));
  Draft alone;
  alone.stairs = -1;
  GoOnStairs({}, alone);
  EXPECT_EQ(alone.action, "") << "no stairs were gone before";
}

}  // namespace
}  // namespace gaitwright::words
