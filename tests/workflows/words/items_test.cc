// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/words/items.h"

#include <gtest/gtest.h>

namespace gaitwright::words {
namespace {

using M = Meaning;
using Meanings = std::vector<Meaning>;

const std::vector<PlaceName>& KnownPlaces() {
  static const std::vector<PlaceName> places = {{"door", 0}, {"red marker", 0}, {"step", 0}, {"stone", 0}};
  return places;
}

std::vector<Item> ItemsIn(const std::string& text) { return ItemsOf(text, LanguageOf(text), KnownPlaces()); }

Meanings MeaningsIn(const std::string& text) {
  Meanings meanings;
  for (const Item& item : ItemsIn(text)) {
    if (!item.SaysNothing()) meanings.push_back(item.meaning);
  }
  return meanings;
}

/// The only item with a meaning; an unknown item without a name if there is none or more than one.
Item OnlyItem(const std::string& text, M meaning) {
  Item found;
  int count = 0;
  for (const Item& item : ItemsIn(text)) {
    if (!item.Is(meaning)) continue;
    found = item;
    ++count;
  }
  EXPECT_EQ(count, 1) << text;
  return count == 1 ? found : Item{};
}

TEST(Items, LanguageIsChineseWhereOneCharacterIs) {
  EXPECT_EQ(LanguageOf("walk"), Language::kEnglish);
  EXPECT_EQ(LanguageOf(""), Language::kEnglish);
  EXPECT_EQ(LanguageOf("，。"), Language::kEnglish) << "signs are no characters";
  EXPECT_EQ(LanguageOf("walk 走"), Language::kChinese);
}

struct AmountSaid {
  std::string text, name;
  double value;
};

class AmountsInWords : public testing::TestWithParam<AmountSaid> {};

TEST_P(AmountsInWords, AreInTheUnitOfTheirQuantity) {
  const Item amount = OnlyItem(GetParam().text, M::kAmount);
  EXPECT_EQ(amount.name, GetParam().name) << GetParam().text;
  EXPECT_NEAR(amount.value, GetParam().value, 1e-9) << GetParam().text;
}

INSTANTIATE_TEST_SUITE_P(
    BothLanguages, AmountsInWords,
    testing::Values(AmountSaid{"walk 50 cm", "m", 0.5}, AmountSaid{"walk two metres", "m", 2.0},
                    AmountSaid{"walk a metre and a half", "m", 1.5}, AmountSaid{"walk two-metre", "m", 2.0},
                    AmountSaid{"turn 90 degrees", "deg", 90.0}, AmountSaid{"wave for half a minute", "s", 30.0},
                    AmountSaid{"walk 3.6 km/h", "m/s", 1.0}, AmountSaid{"nod x2", "times", 2.0},
                    AmountSaid{"take three sideways steps", "steps", 3.0}, AmountSaid{"往前走三米二", "m", 3.2},
                    AmountSaid{"走五步", "steps", 5.0}, AmountSaid{"以每秒零点五米的速度走", "m/s", 0.5}));

TEST(Items, ANumberWithoutAUnitIsANumber) {
  const Item number = OnlyItem("turn left 90", M::kNumber);
  EXPECT_EQ(number.value, 90.0);
  EXPECT_EQ(number.begin, 10U);
  EXPECT_EQ(number.end, 12U);
}

/// Items are in order, do not overlap, and lie in the text.
TEST(Items, PlacesInTheTextAreInOrder) {
  for (const std::string text : {"Please walk to the red marker, then turn left 90 degrees and nod twice.",
                                 "1. nod 2. bow 3. walk three sideways steps", "先往前走三米，再向左转九十度 挥手"}) {
    std::size_t end = 0;
    for (const Item& item : ItemsIn(text)) {
      EXPECT_LE(item.begin, item.end) << text;
      EXPECT_LE(item.end, text.size()) << text;
      EXPECT_GE(item.begin, end) << text << " at " << item.begin;
      end = item.begin;
    }
  }
}

TEST(Items, WhatIsNotKnownIsOneUnknownOverAllItsWords) {
  const std::string text = "walk flibber gibbet, nod";
  const Item unknown = OnlyItem(text, M::kUnknown);
  EXPECT_EQ(text.substr(unknown.begin, unknown.end - unknown.begin), "flibber gibbet");
  EXPECT_EQ(MeaningsIn("walk flabbergastingly"), Meanings{M::kAction}) << "an adverb says only how";
}

TEST(Items, SignsBreakAndQuotesDoNot) {
  EXPECT_EQ(MeaningsIn("nod; bow"), (Meanings{M::kAction, M::kBreak, M::kAction}));
  EXPECT_EQ(MeaningsIn("\"nod\""), Meanings{M::kAction});
  EXPECT_EQ(MeaningsIn("点头 鞠躬"), (Meanings{M::kAction, M::kBreak, M::kAction})) << "a space stands for a comma";
}

TEST(Items, AnEnumerationGoesOnToTheNextTask) {
  EXPECT_EQ(MeaningsIn("1. nod 2. bow"), (Meanings{M::kThen, M::kAction, M::kThen, M::kAction}));
  EXPECT_EQ(MeaningsIn("a) nod b) bow"), (Meanings{M::kThen, M::kAction, M::kThen, M::kAction}));
}

TEST(Items, PlacesAreKnownByNameNumberAndTranslation) {
  EXPECT_EQ(OnlyItem("walk to the red marker", M::kPlace).name, "red marker");
  EXPECT_EQ(OnlyItem("走到门", M::kPlace).name, "door");
  EXPECT_EQ(OnlyItem("walk to stone number 4", M::kPlace).value, 4.0);
  EXPECT_EQ(OnlyItem("walk to the second stone", M::kPlace).value, 2.0);
  EXPECT_EQ(OnlyItem("walk to stone one", M::kPlace).value, 1.0);
}

/// "step" is a place after "to" or with a number, and otherwise an action.
TEST(Items, ANameThatIsAnotherWordTooIsAPlaceOnlyWhereOneIsExpected) {
  EXPECT_EQ(OnlyItem("walk to the step", M::kPlace).name, "step");
  EXPECT_EQ(MeaningsIn("step forward"), (Meanings{M::kAction, M::kDirection}));
}

TEST(Items, OneFootStandsAndAFootIsALength) {
  EXPECT_NEAR(OnlyItem("walk a foot", M::kAmount).value, 0.3048, 1e-12);
  EXPECT_EQ(OnlyItem("stand on one foot", M::kAction).name, "balance");
}

TEST(Items, WithoutPlacesTheNameOfOneIsUnknown) {
  const std::string text = "walk to the red marker";
  bool place = false;
  for (const Item& item : ItemsOf(text, Language::kEnglish, {})) place = place || item.Is(M::kPlace);
  EXPECT_FALSE(place);
  EXPECT_TRUE(ItemsOf("", Language::kEnglish, KnownPlaces()).empty());
}

}  // namespace
}  // namespace gaitwright::words
