// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/words/forbidden.h"

#include <gtest/gtest.h>

#include "workflows/words/items.h"

namespace gaitwright::words {
namespace {

/// The single clause of a text.
Clause OnlyClause(const std::string& text) {
  const std::vector<Clause> clauses = ClausesOf(text, ItemsOf(text, LanguageOf(text), {}));
  EXPECT_EQ(clauses.size(), 1U) << text;
  return clauses.empty() ? Clause{} : clauses.front();
}

Draft AskedFor(const std::string& action, const std::string& key = "", TaskValue value = 0) {
  Draft draft;
  draft.action = action;
  if (!key.empty()) draft.parameters[key] = std::move(value);
  return draft;
}

FailureCode CodeOfForbidden(const std::string& text, std::vector<Draft> drafts) {
  Forbidden forbidden(text);
  try {
    forbidden.Add(OnlyClause(text), drafts);
    forbidden.Check(drafts);
  } catch (const Refused& refused) {
    return refused.refusal.code;
  }
  return FailureCode::kInternal;
}

bool IsAccepted(const std::string& text, const std::vector<Draft>& drafts) {
  return CodeOfForbidden(text, drafts) == FailureCode::kInternal;
}

TEST(ForbiddenTasks, ATaskThatWasAskedForIsTakenBack) {
  const std::string text = "don't nod";
  std::vector<Draft> drafts = {AskedFor("bow"), AskedFor("nod"), AskedFor("squat")};
  Forbidden forbidden(text);
  EXPECT_TRUE(forbidden.Add(OnlyClause(text), drafts));
  ASSERT_EQ(drafts.size(), 2U);
  EXPECT_EQ(drafts[0].action, "bow");
  EXPECT_EQ(drafts[1].action, "squat");
  EXPECT_NO_THROW(forbidden.Check(drafts));
}

TEST(ForbiddenTasks, TheLastOfSeveralIsTakenBackAndGesturesToo) {
  const std::string text = "don't nod";
  Draft walk = AskedFor("walk", "direction", std::string("forward"));
  walk.during = {AskedFor("nod")};
  std::vector<Draft> drafts = {AskedFor("nod"), walk};
  Forbidden forbidden(text);
  EXPECT_TRUE(forbidden.Add(OnlyClause(text), drafts));
  EXPECT_EQ(drafts.size(), 2U);
  EXPECT_TRUE(drafts[1].during.empty()) << "the gesture beside the walk came last";
}

TEST(ForbiddenTasks, AnotherFormOfTheRequestIsOnlyNoted) {
  const std::vector<Draft> left = {AskedFor("turn", "direction", std::string("left"))},
                           right = {AskedFor("turn", "direction", std::string("right"))};
  EXPECT_TRUE(IsAccepted("don't turn right", left));
  EXPECT_TRUE(IsAccepted("don't turn right", right)) << "it is taken back";
}

TEST(ForbiddenTasks, WhatIsLikeNothingThatIsAskedForIsRefused) {
  EXPECT_EQ(CodeOfForbidden("don't squat", {AskedFor("nod")}), FailureCode::kUnknown);
  EXPECT_EQ(CodeOfForbidden("don't squat", {}), FailureCode::kUnknown);
}

TEST(ForbiddenTasks, AskingLaterForWhatIsForbiddenIsRefused) {
  const std::string text = "don't nod";
  std::vector<Draft> drafts;
  Forbidden forbidden(text);
  EXPECT_FALSE(forbidden.Add(OnlyClause(text), drafts));
  drafts = {AskedFor("nod")};
  EXPECT_THROW(forbidden.Check(drafts), Refused);
}

TEST(ForbiddenTasks, WhatEndsMustHaveBegun) {
  const std::string text = "stop waving";
  std::vector<Draft> waves = {AskedFor("wave")}, nods = {AskedFor("nod")};
  Forbidden forbidden(text);
  EXPECT_TRUE(forbidden.Add(OnlyClause(text), waves));
  EXPECT_EQ(waves.size(), 1U) << "what was done stays";
  EXPECT_THROW(forbidden.Add(OnlyClause(text), nods), Refused);
}

}  // namespace
}  // namespace gaitwright::words
