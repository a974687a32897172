// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/words/asides.h"

#include <gtest/gtest.h>

#include "workflows/words/items.h"

namespace gaitwright::words {
namespace {

using M = Meaning;

std::vector<Item> ItemsWithAsides(const std::string& text) { return ItemsOf(text, LanguageOf(text), {{"door", 0}}); }

/// The remaining words, with a bar between items; words without a meaning are left out.
std::string KeptWords(const std::string& text) {
  std::string kept;
  for (const Item& item : WithoutAsides(ItemsWithAsides(text))) {
    if (item.SaysNothing() || item.Is(M::kBreak)) continue;
    kept += (kept.empty() ? "" : "|") + text.substr(item.begin, item.end - item.begin);
  }
  return kept;
}

bool HasUnknown(const std::string& text) {
  for (const Item& item : WithoutAsides(ItemsWithAsides(text))) {
    if (item.Is(M::kUnknown)) return true;
  }
  return false;
}

TEST(Asides, AnInstructionWithoutOneIsKeptWhole) {
  for (const std::string text :
       {"walk to the door and nod twice", "turn left 90 degrees, then squat", "先点头，再鞠躬"}) {
    const std::vector<Item> all = ItemsWithAsides(text), kept = WithoutAsides(all);
    ASSERT_EQ(kept.size(), all.size()) << text;
    for (std::size_t k = 0; k < all.size(); ++k) {
      EXPECT_EQ(kept[k].meaning, all[k].meaning) << text;
      EXPECT_EQ(kept[k].begin, all[k].begin) << text;
    }
  }
  EXPECT_TRUE(WithoutAsides({}).empty());
}

TEST(Asides, ReasonsAreLeftOut) {
  EXPECT_EQ(KeptWords("nod because the floor is wet"), "nod");
  EXPECT_EQ(KeptWords("nod because the floor is wet, bow"), "nod|bow") << "up to the comma";
  EXPECT_EQ(KeptWords("nod because the floor is wet, then bow"), "nod|then|bow");
}

TEST(Asides, WhatSomebodyElseDoesIsLeftOut) {
  EXPECT_EQ(KeptWords("the nurse has to pass, nod"), "nod");
  EXPECT_EQ(KeptWords("妈妈接个电话，点头"), "点头");
}

TEST(Asides, WhenOthersActIsLeftOut) {
  EXPECT_EQ(KeptWords("nod before the visitors arrive"), "nod");
  EXPECT_FALSE(HasUnknown("squat while I take a picture"));
}

/// Conditions on other people are things that the robot cannot observe.
TEST(Asides, ConditionsStayAndAreUnknown) { EXPECT_TRUE(HasUnknown("nod if the door is open")); }

TEST(Asides, WhatIsOrderedIsNoAside) {
  EXPECT_EQ(KeptWords("nod before you bow").find("bow") != std::string::npos, true);
  EXPECT_FALSE(HasUnknown("nod before you bow"));
}

/// Removing asides a second time changes nothing.
TEST(Asides, OnceIsEnough) {
  for (const std::string text :
       {"nod because the floor is wet, then bow", "妈妈接个电话，点头", "the nurse has to pass, nod"}) {
    const std::vector<Item> once = WithoutAsides(ItemsWithAsides(text)), twice = WithoutAsides(once);
    EXPECT_EQ(twice.size(), once.size()) << text;
  }
}

}  // namespace
}  // namespace gaitwright::words
