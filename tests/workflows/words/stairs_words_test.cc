// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/words/stairs_words.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "workflows/words/places.h"

namespace gaitwright::words {
namespace {

using M = Meaning;

Item ItemWith(M meaning, double value = 0.0, const std::string& name = "") {
  Item item;
  item.meaning = meaning;
  item.value = value;
  item.name = name;
  return item;
}

std::pair<Item, std::size_t> WordIn(const std::string& text, const std::vector<Item>& before = {}) {
  return StairsWordAt(PiecesOf(text), 0, before);
}

/// The place of a phrase; a place without a name if there is none.
PlaceName PlaceOfPhrase(const std::string& phrase, const std::vector<PlaceName>& places) {
  PlaceName found{"", 0};
  for (const auto& [named, place] : StairsPlaces(places)) {
    if (named == phrase) found = place;
  }
  return found;
}

TEST(StairsWords, StepsAreCalledSoInBothLanguages) {
  for (const char* name : {"step", "stair", "台阶"}) EXPECT_TRUE(IsStep(name)) << name;
  for (const char* name : {"stone", "steps", ""}) EXPECT_FALSE(IsStep(name)) << name;
}

TEST(StairsWords, TheTopIsTheLastStep) {
  const std::vector<PlaceName> stairs = {{"step", 0}};
  EXPECT_EQ(PlaceOfPhrase("the top of the stairs", stairs), (PlaceName{"step", -1}));
  EXPECT_EQ(PlaceOfPhrase("楼梯顶", stairs), (PlaceName{"step", -1}));
  EXPECT_EQ(PlaceOfPhrase("stair", stairs), (PlaceName{"step", 0}));
  EXPECT_EQ(PlaceOfPhrase("the top of the stairs", {{"stone", 0}}).name, "");
  EXPECT_TRUE(StairsPlaces({}).empty());
}

TEST(StairsWords, TheEndsOfStairsHaveWordsOfTheirOwn) {
  EXPECT_EQ(PlaceOfPhrase("foot of the stairs", {{kStartOfStairs, 0}}).name, kStartOfStairs);
  EXPECT_EQ(PlaceOfPhrase("far side of the stairs", {{kEndOfStairs, 0}}).name, kEndOfStairs);
  EXPECT_EQ(PlaceOfPhrase("far side of the stairs", {{kStartOfStairs, 0}}).name, "");
}

TEST(StairsWords, APlaceOfTheGroundOfThatNameComesFirst) {
  EXPECT_EQ(PlaceOfPhrase("landing", {{"step", 0}, {"landing", 0}}).name, "");
  EXPECT_EQ(PlaceOfPhrase("landing", {{"step", 0}}).name, "step");
}

TEST(StairsWords, TheNextStepIsOneWhereAPlaceIsToFollow) {
  const auto [next, count] = WordIn("next step", {ItemWith(M::kTo)});
  EXPECT_EQ(count, 2U);
  EXPECT_TRUE(next.Is(M::kStairs));
  EXPECT_EQ(next.value, 2.0);
  EXPECT_EQ(WordIn("next step").second, 0U);
  EXPECT_EQ(WordIn("下一级台阶", {ItemWith(M::kAction, kToPlace)}).second, 5U) << "with its noun";
  EXPECT_EQ(WordIn("下一级", {ItemWith(M::kTo)}).second, 3U);
}

TEST(StairsWords, UpBeforeANumberOfStepsIsAVerbOrADirection) {
  const auto [up, count] = WordIn("上两级");
  EXPECT_EQ(count, 1U) << "the number is read by itself";
  EXPECT_TRUE(up.Is(M::kAction));
  EXPECT_EQ(up.value, kUpStairs);
  EXPECT_EQ(WordIn("下三级").first.value, kDownStairs);
  EXPECT_TRUE(WordIn("下三级", {ItemWith(M::kAction)}).first.Is(M::kDown)) << "after a verb it is its way";
  EXPECT_EQ(WordIn("上三米").second, 0U);
}

TEST(StairsWords, GoingUpBeginsASentence) {
  EXPECT_EQ(WordIn("上去").first.value, kUpwards);
  EXPECT_EQ(WordIn("下去", {ItemWith(M::kBreak)}).first.value, kDownwards);
  EXPECT_EQ(WordIn("上去", {ItemWith(M::kAction)}).second, 0U);
}

TEST(StairsWords, OneAtTheEndIsAStepOfWhatGoesUpOrDown) {
  const auto [one, count] = WordIn("one", {ItemWith(M::kAction, kUpStairs)});
  EXPECT_EQ(count, 1U);
  EXPECT_EQ(one.name, "treads");
  EXPECT_EQ(one.value, 1.0);
  EXPECT_EQ(WordIn("one metre", {ItemWith(M::kAction, kUpStairs)}).second, 0U);
  EXPECT_EQ(WordIn("one", {ItemWith(M::kAction)}).second, 0U);
}

TEST(StairsWords, ANumberOfStepsIsAnAmountAfterAVerbOfStairs) {
  const auto joined = [](double verb) {
    std::vector<Item> items = {ItemWith(M::kAction, verb), ItemWith(M::kNumber, 2.0), ItemWith(M::kFiller, 0.0, "级"),
                               ItemWith(M::kStairs)};
    for (std::size_t k = 0; k < items.size(); ++k) items[k].begin = k, items[k].end = k + 1;
    JoinStairs(items);
    return items;
  };
  const std::vector<Item> up = joined(kUpStairs);
  ASSERT_EQ(up.size(), 2U);
  EXPECT_TRUE(up[1].Is(M::kAmount));
  EXPECT_EQ(up[1].name, "treads");
  EXPECT_EQ(up[1].value, 2.0);
  EXPECT_EQ(up[1].end, 4U);
  EXPECT_EQ(joined(0.0).size(), 4U) << "which one, rather than how many";
}

TEST(StairsWords, TheFirstStepsOfStairsAreSoManyAndTheLastAreUnknown) {
  const auto ordinal = [](double which) {
    std::vector<Item> items = {ItemWith(M::kAction, kUpStairs), ItemWith(M::kOrdinal, which),
                               ItemWith(M::kAmount, 2.0, "steps")};
    JoinStairs(items);
    return items[1].meaning;
  };
  EXPECT_EQ(ordinal(1.0), M::kFiller);
  EXPECT_EQ(ordinal(-1.0), M::kUnknown);
}

}  // namespace
}  // namespace gaitwright::words
