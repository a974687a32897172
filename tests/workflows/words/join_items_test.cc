// SPDX-License-Identifier: BSD-3-Clause
// Hand-made rows of items.
#include "workflows/words/join_items.h"

#include <gtest/gtest.h>

namespace gaitwright::words {
namespace {

using M = Meaning;

/// Consecutive items of two bytes each.
class ItemRow {
 public:
  ItemRow& Add(M meaning, const std::string& name = "", double value = 0.0) {
    Item item;
    item.meaning = meaning;
    item.name = name;
    item.value = value;
    item.begin = 2 * items_.size();
    item.end = item.begin + 2;
    items_.push_back(item);
    return *this;
  }
  std::vector<Item> Joined() const {
    std::vector<Item> items = items_;
    JoinItems(items);
    return items;
  }

 private:
  std::vector<Item> items_;
};

TEST(JoinItems, ALengthPerSecondIsASpeed) {
  const auto items = ItemRow().Add(M::kUnit, "m/s", 0.5).Add(M::kFiller).Add(M::kAmount, "m", 3.0).Joined();
  ASSERT_EQ(items.size(), 1U);
  EXPECT_TRUE(items[0].Is(M::kAmount));
  EXPECT_EQ(items[0].name, "m/s");
  EXPECT_EQ(items[0].value, 1.5);
  EXPECT_EQ(items[0].begin, 0U);
  EXPECT_EQ(items[0].end, 6U) << "up to the end of the length";
  EXPECT_EQ(ItemRow().Add(M::kUnit, "m/s", 1.0).Add(M::kAmount, "deg", 3.0).Joined().size(), 2U);
}

TEST(JoinItems, AnOrdinalIsTheNumberOfThePlaceAfterIt) {
  const auto items = ItemRow().Add(M::kTo).Add(M::kOrdinal, "", 2.0).Add(M::kFiller).Add(M::kPlace, "stone").Joined();
  ASSERT_EQ(items.size(), 2U);
  EXPECT_TRUE(items[1].Is(M::kPlace));
  EXPECT_EQ(items[1].value, 2.0);
  EXPECT_EQ(items[1].begin, 2U) << "from the ordinal on";
}

TEST(JoinItems, ANumberAfterAPlaceIsItsNumberUnlessItHasOne) {
  const auto items = ItemRow().Add(M::kPlace, "stone").Add(M::kNumber, "", 4.0).Joined();
  ASSERT_EQ(items.size(), 1U);
  EXPECT_EQ(items[0].value, 4.0);
  EXPECT_EQ(items[0].end, 4U);
  const auto numbered = ItemRow().Add(M::kPlace, "stone", 1.0).Add(M::kNumber, "", 4.0).Joined();
  EXPECT_EQ(numbered[0].value, 1.0);
  EXPECT_EQ(numbered.size(), 2U);
}

TEST(JoinItems, TheSecondOneIsAPlaceOfTheNameBefore) {
  const auto items =
      ItemRow().Add(M::kPlace, "stone", 1.0).Add(M::kThen).Add(M::kOrdinal, "", 2.0).Add(M::kFiller, "one").Joined();
  ASSERT_GE(items.size(), 3U);
  EXPECT_TRUE(items[2].Is(M::kPlace));
  EXPECT_EQ(items[2].name, "stone");
  EXPECT_EQ(items[2].value, 2.0);
}

TEST(JoinItems, AnOrdinalOfNothingGoesOnOrPutsFirst) {
  EXPECT_TRUE(ItemRow().Add(M::kOrdinal, "", 1.0).Add(M::kAction, "nod").Joined()[0].Is(M::kThen));
  EXPECT_TRUE(ItemRow().Add(M::kAction, "nod").Add(M::kOrdinal, "", 1.0).Joined()[1].Is(M::kFirst));
  EXPECT_TRUE(ItemRow().Add(M::kAction, "nod").Add(M::kOrdinal, "", 2.0).Joined()[1].Is(M::kThen));
}

TEST(JoinItems, AndBetweenPlacesGoesOnToTheNext) {
  const auto places =
      ItemRow().Add(M::kPlace, "stone", 1.0).Add(M::kFiller, "and").Add(M::kPlace, "stone", 2.0).Joined();
  EXPECT_TRUE(places[1].Is(M::kThen));
  const auto actions = ItemRow().Add(M::kAction, "nod").Add(M::kFiller, "and").Add(M::kAction, "bow").Joined();
  EXPECT_TRUE(actions[1].Is(M::kFiller));
}

TEST(JoinItems, BeforeIsMeantWhereAnActionEndsWithIt) {
  const auto joined = [](M then) {
    return ItemRow().Add(M::kAction, "bow").Add(M::kFiller, "前").Add(then).Add(M::kAction, "nod").Joined()[1];
  };
  EXPECT_TRUE(joined(M::kBreak).Is(M::kBefore));
  EXPECT_TRUE(joined(M::kThen).Is(M::kBefore));
  EXPECT_TRUE(joined(M::kFiller).Is(M::kFiller));
}

TEST(JoinItems, AnUnknownAdverbSaysHow) {
  EXPECT_TRUE(ItemRow().Add(M::kUnknown).Add(M::kFiller, "地").Joined()[0].Is(M::kFiller));
  EXPECT_TRUE(ItemRow().Add(M::kUnknown).Add(M::kFiller, "的").Joined()[0].Is(M::kUnknown));
}

/// "to the step" without a place of this name.
TEST(JoinItems, APlaceThatIsNotKnownIsUnknownWithItsArticle) {
  const auto items = ItemRow().Add(M::kTo).Add(M::kFiller, "the").Add(M::kAction, "walk").Joined();
  ASSERT_EQ(items.size(), 2U);
  EXPECT_TRUE(items[1].Is(M::kUnknown));
  EXPECT_EQ(items[1].begin, 2U);
  EXPECT_EQ(items[1].end, 6U);
  EXPECT_EQ(ItemRow().Add(M::kFiller, "the").Add(M::kAction, "walk").Joined().size(), 2U) << "nothing leads to it";
}

}  // namespace
}  // namespace gaitwright::words
