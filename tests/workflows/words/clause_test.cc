// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/words/clause.h"

#include <gtest/gtest.h>

#include "workflows/words/items.h"

namespace gaitwright::words {
namespace {

using Texts = std::vector<std::string>;

std::vector<Clause> ClausesIn(const std::string& text) {
  return ClausesOf(text, ItemsOf(text, LanguageOf(text), {{"door", 0}}));
}

/// The words of each clause.
Texts ClauseWords(const std::string& text) {
  Texts words;
  for (const Clause& clause : ClausesIn(text)) words.push_back(TextOf(text, clause.Words()));
  return words;
}

TEST(Clauses, APartEachForWhatIsJoinedByWordsOrSigns) {
  EXPECT_EQ(ClauseWords("nod, then bow"), (Texts{"nod", "bow"}));
  EXPECT_EQ(ClauseWords("nod. bow; squat"), (Texts{"nod", "bow", "squat"}));
  EXPECT_EQ(ClauseWords("点头，然后鞠躬"), (Texts{"点头", "鞠躬"}));
  EXPECT_TRUE(ClausesIn("").empty());
  EXPECT_TRUE(ClausesIn(" ,,, ").empty());
  EXPECT_TRUE(ClausesIn("please").empty()) << "politeness alone asks for nothing";
}

TEST(Clauses, ASecondActionBeginsAClauseOfItsOwn) {
  EXPECT_EQ(ClauseWords("nod and bow"), (Texts{"nod", "bow"}));
  EXPECT_EQ(ClauseWords("举手往前走"), (Texts{"举手", "往前走"})) << "the way belongs to the verb after it";
}

TEST(Clauses, SayHowTheyFollow) {
  const std::vector<Clause> then = ClausesIn("nod then bow");
  ASSERT_EQ(then.size(), 2U);
  EXPECT_FALSE(then[0].follows_then);
  EXPECT_TRUE(then[1].follows_then);
  const std::vector<Clause> comma = ClausesIn("nod, bow");
  ASSERT_EQ(comma.size(), 2U);
  EXPECT_TRUE(comma[1].follows_break);
  EXPECT_FALSE(comma[1].follows_then);
  EXPECT_TRUE(ClausesIn("nod before you bow").back().is_before);
  EXPECT_TRUE(ClausesIn("nod after you bow").back().is_after);
}

TEST(Clauses, WhatIsDoneMeanwhileIsMarkedFromItsWordOn) {
  const std::string text = "walk forward while you wave";
  const std::vector<Clause> clauses = ClausesIn(text);
  ASSERT_EQ(clauses.size(), 2U);
  EXPECT_TRUE(clauses[1].is_meanwhile);
  EXPECT_EQ(clauses[1].since, text.find("while"));
  EXPECT_TRUE(clauses[0].refers) << "the one before only names what goes on";
  EXPECT_FALSE(clauses[1].refers);
  EXPECT_TRUE(ClausesIn("walk forward with both hands up").back().is_meanwhile) << "a gesture beside the walk";
}

TEST(Clauses, NoCorrectsAVerbAndForbidsAGerund) {
  const std::vector<Clause> corrected = ClausesIn("turn left, no, turn right");
  EXPECT_TRUE(corrected.back().corrects);
  EXPECT_FALSE(corrected.back().forbids);
  const std::vector<Clause> forbidden = ClausesIn("no walking");
  ASSERT_EQ(forbidden.size(), 1U);
  EXPECT_TRUE(forbidden[0].forbids);
  EXPECT_FALSE(forbidden[0].ends);
}

TEST(Clauses, DoNotForbidsAndStopEnds) {
  const Clause never = ClausesIn("don't walk").front();
  EXPECT_TRUE(never.forbids);
  EXPECT_FALSE(never.ends);
  const Clause stop = ClausesIn("wave, then stop waving").back();
  EXPECT_TRUE(stop.forbids);
  EXPECT_TRUE(stop.ends);
  const Clause stand = ClausesIn("stop").front();
  EXPECT_FALSE(stand.forbids) << "alone it is an action";
  EXPECT_TRUE(ClausesIn("停止挥手").front().ends);
  EXPECT_TRUE(ClausesIn("不要走").front().forbids);
}

TEST(Clauses, WhatIsTakenBackIsDroppedByNameWhereOneIsGiven) {
  const Clause any = ClausesIn("nod, never mind").back();
  EXPECT_TRUE(any.drops);
  EXPECT_EQ(any.dropped, "");
  const Clause bow = ClausesIn("点头，鞠躬就免了").back();
  EXPECT_TRUE(bow.drops);
  EXPECT_EQ(bow.dropped, "bow");
}

TEST(Clauses, AgainAndHoldStandAlone) {
  const std::vector<Clause> again = ClausesIn("nod, again");
  ASSERT_EQ(again.size(), 2U);
  EXPECT_TRUE(again[1].again);
  const std::vector<Clause> same = ClausesIn("nod again");
  ASSERT_EQ(same.size(), 1U) << "it belongs to its verb";
  EXPECT_FALSE(same[0].again);
  EXPECT_TRUE(ClausesIn("squat, hold it for five seconds").back().holds);
}

TEST(Clauses, PolitenessIsNoPartOfTheWords) {
  const std::string text = "please nod twice please";
  const std::vector<Clause> clauses = ClausesIn(text);
  ASSERT_FALSE(clauses.empty());
  EXPECT_EQ(TextOf(text, clauses.front().Words()), "nod twice");
}

TEST(Clauses, AClauseOfWordsThatSayNothingIsEmpty) {
  Clause clause;
  EXPECT_TRUE(clause.empty());
  EXPECT_EQ(clause.Words().end, 0U);
  Item item;
  item.meaning = Meaning::kFiller;
  clause.items.push_back(item);
  EXPECT_TRUE(clause.empty());
  item.meaning = Meaning::kSide;
  clause.items.push_back(item);
  EXPECT_FALSE(clause.empty());
}

}  // namespace
}  // namespace gaitwright::words
