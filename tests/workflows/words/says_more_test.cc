// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/words/says_more.h"

#include <gtest/gtest.h>

namespace gaitwright::words {
namespace {

/// A draft with its words in a text of the same letters.
class SaidDraft {
 public:
  explicit SaidDraft(const std::string& action, std::size_t begin = 0) {
    draft_.action = action;
    draft_.words = {begin, begin + 4};
    if (action == "walk") draft_.parameters["direction"] = std::string("forward");
  }
  SaidDraft& Say(const std::string& key, TaskValue value) {
    draft_.parameters[key] = std::move(value);
    draft_.said[key] = draft_.words;
    return *this;
  }
  SaidDraft& Take(const std::string& key, TaskValue value) {
    draft_.parameters[key] = std::move(value);
    return *this;
  }
  const Draft& draft() const { return draft_; }

 private:
  Draft draft_;
};

const std::string kTwelveLetters = "abcdefghijkl";

/// A clause after a comma, whose first item is at the position of the second draft.
Clause AfterComma() {
  Clause clause;
  clause.follows_break = true;
  Item verb;
  verb.meaning = Meaning::kAction;
  verb.begin = 6;
  verb.end = 10;
  clause.items.push_back(verb);
  return clause;
}

/// Whether the second draft adds to the first; `last` then has the parameters of both.
bool SaysMoreOf(const SaidDraft& before, const SaidDraft& said, Draft& last, const Clause& clause = AfterComma()) {
  last = before.draft();
  return SaysMore(kTwelveLetters, clause, said.draft(), last);
}

bool SaysMoreOf(const SaidDraft& before, const SaidDraft& said, const Clause& clause = AfterComma()) {
  Draft ignored;
  return SaysMoreOf(before, said, ignored, clause);
}

TEST(SaysMore, AnAmountAfterTheSameActionIsOfThatOne) {
  Draft last;
  EXPECT_TRUE(SaysMoreOf(SaidDraft("sit"), SaidDraft("sit", 6).Say("duration_s", 20.0), last));
  EXPECT_EQ(std::get<double>(last.parameters.at("duration_s")), 20.0);
  EXPECT_FALSE(SaysMoreOf(SaidDraft("nod").Say("times", 2), SaidDraft("nod", 6).Say("times", 3)))
      << "two amounts are two tasks";
  EXPECT_FALSE(SaysMoreOf(SaidDraft("sit"), SaidDraft("bow", 6).Say("duration_s", 20.0))) << "another action";
}

TEST(SaysMore, ThenBeginsATaskOfItsOwn) {
  Clause clause = AfterComma();
  clause.follows_then = true;
  EXPECT_FALSE(SaysMoreOf(SaidDraft("sit"), SaidDraft("sit", 6).Say("duration_s", 20.0), clause));
}

TEST(SaysMore, AWalkInTheSameDirectionIsTheSameWalk) {
  Draft last;
  EXPECT_TRUE(SaysMoreOf(SaidDraft("walk"), SaidDraft("walk", 6).Say("direction", std::string("forward")), last));
  EXPECT_TRUE(SaysMoreOf(SaidDraft("walk").Say("direction", std::string("forward")),
                         SaidDraft("walk", 6).Say("direction", std::string("forward")).Say("distance_m", 2.0), last));
  EXPECT_EQ(std::get<double>(last.parameters.at("distance_m")), 2.0);
  EXPECT_FALSE(SaysMoreOf(SaidDraft("walk").Say("direction", std::string("forward")),
                          SaidDraft("walk", 6).Say("direction", std::string("left")).Say("distance_m", 2.0)));
  EXPECT_FALSE(SaysMoreOf(SaidDraft("walk").Say("distance_m", 1.0), SaidDraft("walk", 6).Say("distance_m", 2.0)))
      << "the first walk is said whole";
}

TEST(SaysMore, StandingForATimeIsHowLongABalanceLasts) {
  Draft last;
  const SaidDraft stands = SaidDraft("stand", 6).Say("duration_s", 5.0);
  EXPECT_TRUE(SaysMoreOf(SaidDraft("balance").Say("side", std::string("right")), stands, last));
  EXPECT_EQ(last.action, "balance");
  EXPECT_EQ(std::get<double>(last.parameters.at("duration_s")), 5.0);
  EXPECT_FALSE(SaysMoreOf(SaidDraft("balance").Say("duration_s", 1.0), stands)) << "it has a time";
  EXPECT_FALSE(SaysMoreOf(SaidDraft("bow"), stands));
}

/// Implied parameters, such as the right hand, are not additions.
TEST(SaysMore, WhatIsTakenAsReadAddsNothing) {
  Draft last;
  EXPECT_TRUE(SaysMoreOf(SaidDraft("wave").Say("side", std::string("left")),
                         SaidDraft("wave", 6).Take("side", std::string("right")).Say("times", 3), last));
  EXPECT_EQ(std::get<std::string>(last.parameters.at("side")), "left");
  EXPECT_EQ(last.parameters.at("times"), TaskValue(3));
}

TEST(SaysMore, HowFarIsADistanceATimeOrAPlace) {
  EXPECT_FALSE(SaysHowFar(SaidDraft("walk").draft()));
  EXPECT_FALSE(SaysHowFar(SaidDraft("walk").Say("pace", std::string("slow")).draft()));
  for (const std::string& key : ExtentKeys()) EXPECT_TRUE(SaysHowFar(SaidDraft("walk").Say(key, 1.0).draft())) << key;
}

TEST(SaysMore, HowToWalkIsPaceHeightSpeedGaitAndTime) {
  const auto only = [](const std::string& key) {
    Draft draft;
    draft.parameters[key] = std::string("x");
    return SaysOnlyHow(draft);
  };
  for (const char* key : {"pace", "height", "speed_m_s", "gait", "duration_s"}) EXPECT_TRUE(only(key)) << key;
  for (const char* key : {"direction", "distance_m", "times"}) EXPECT_FALSE(only(key)) << key;
  EXPECT_FALSE(SaysOnlyHow({}));
  Draft sided;
  sided.parameters["pace"] = std::string("slow");
  sided.side = "left";
  EXPECT_FALSE(SaysOnlyHow(sided));
}

TEST(SaysMore, ATurnWithOnlyADirectionReversesTheLastOne) {
  const Draft right = SaidDraft("turn", 6).Say("direction", std::string("right")).draft();
  const Draft sixty = SaidDraft("turn").Say("direction", std::string("left")).Say("angle_deg", 60.0).draft();
  EXPECT_TRUE(OnlyTurnsRound(right, {sixty}));
  EXPECT_FALSE(OnlyTurnsRound(right, {}));
  EXPECT_FALSE(OnlyTurnsRound(right, {SaidDraft("walk").draft()}));
  EXPECT_FALSE(OnlyTurnsRound(sixty, {sixty})) << "it says how far";
}

}  // namespace
}  // namespace gaitwright::words
