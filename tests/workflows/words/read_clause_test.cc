// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/words/read_clause.h"

#include <gtest/gtest.h>

#include "workflows/words/items.h"

namespace gaitwright::words {
namespace {

/// The draft of the first clause of a text.
Draft ReadFirst(const std::string& text) {
  const std::vector<Clause> clauses = ClausesOf(text, ItemsOf(text, LanguageOf(text), {{"door", 0}, {"stone", 4}}));
  if (clauses.empty()) throw std::logic_error("no clause in: " + text);
  return ReadClause(text, clauses.front());
}

Refusal RefusalOfClause(const std::string& text) {
  try {
    ReadFirst(text);
  } catch (const Refused& refused) {
    return refused.refusal;
  }
  ADD_FAILURE() << "nothing was refused: " << text;
  return {};
}

struct ClauseSaid {
  std::string text, action, key;
  TaskValue value;
};

class ReadClauses : public testing::TestWithParam<ClauseSaid> {};

TEST_P(ReadClauses, SayTheirActionAndParameter) {
  const Draft draft = ReadFirst(GetParam().text);
  EXPECT_EQ(draft.action, GetParam().action) << GetParam().text;
  ASSERT_TRUE(draft.parameters.contains(GetParam().key)) << GetParam().text;
  EXPECT_EQ(draft.parameters.at(GetParam().key), GetParam().value) << GetParam().text;
}

INSTANTIATE_TEST_SUITE_P(English, ReadClauses,
                         testing::Values(ClauseSaid{"walk two metres", "walk", "distance_m", 2.0},
                                         ClauseSaid{"walk backward 3 steps", "walk", "direction",
                                                    std::string("backward")},
                                         ClauseSaid{"walk 3 steps", "walk", "steps", 3},
                                         ClauseSaid{"walk to the door", "walk", "to", PlaceName{"door", 0}},
                                         ClauseSaid{"walk to the second stone", "walk", "to", PlaceName{"stone", 2}},
                                         ClauseSaid{"walk at 0.3 m/s", "walk", "speed_m_s", 0.3},
                                         ClauseSaid{"turn 90 degrees", "turn", "angle_deg", 90.0},
                                         ClauseSaid{"nod twice", "nod", "times", 2},
                                         ClauseSaid{"stand for ten seconds", "stand", "duration_s", 10.0}));
INSTANTIATE_TEST_SUITE_P(Chinese, ReadClauses,
                         testing::Values(ClauseSaid{"往前走两米", "walk", "distance_m", 2.0},
                                         ClauseSaid{"点头三次", "nod", "times", 3},
                                         ClauseSaid{"走到门", "walk", "to", PlaceName{"door", 0}}));

TEST(ReadClauses, ASideStaysOpenUntilItsActionIsKnown) {
  const Draft draft = ReadFirst("turn left");
  EXPECT_EQ(draft.action, "turn");
  const bool left = draft.side == "left" || (draft.parameters.contains("direction") &&
                                             draft.parameters.at("direction") == TaskValue(std::string("left")));
  EXPECT_TRUE(left);
}

TEST(ReadClauses, ANumberAloneHasNoUnit) {
  const Draft draft = ReadFirst("walk forward 3");
  ASSERT_TRUE(draft.bare);
  EXPECT_EQ(draft.bare->value, 3.0);
  EXPECT_FALSE(draft.parameters.contains("distance_m"));
}

TEST(ReadClauses, ToNothingGoesNowhere) {
  EXPECT_TRUE(ReadFirst("walk to the").to_nowhere);
  EXPECT_FALSE(ReadFirst("walk to the door").to_nowhere);
}

TEST(ReadClauses, WhatIsNotKnownIsRefusedByItsWords) {
  const Refusal whole = RefusalOfClause("flibber the gibbet");
  EXPECT_EQ(whole.code, FailureCode::kUnknown);
  EXPECT_EQ(whole.part, "flibber the gibbet") << "what begins with it is not known on the whole";
  EXPECT_NE(RefusalOfClause("walk flibber two metres").part.find("flibber"), std::string::npos);
}

TEST(ReadClauses, ParametersAreSaidWhereTheyStand) {
  const std::string text = "please walk forward two metres slowly";
  const Draft draft = ReadFirst(text);
  EXPECT_EQ(TextOf(text, SpanOf(draft, "distance_m")), "two metres");
  EXPECT_EQ(TextOf(text, draft.words), "walk forward two metres slowly");
}

}  // namespace
}  // namespace gaitwright::words
