// SPDX-License-Identifier: BSD-3-Clause
// From clauses to tasks: their order, cancelled tasks, and refusals.
#include "workflows/words/understand.h"

#include <gtest/gtest.h>

#include "tests/workflows/words/corpus.h"

namespace gaitwright {
namespace {

/// The actions that an instruction to NAO requests, in order; gestures follow a +.
std::string UnderstoodActions(const std::string& text) {
  static const TaskScope scope = CorpusScope("nao");
  const auto understood = words::Understand(text, scope);
  if (const auto* refusal = std::get_if<words::Refusal>(&understood))
    return "refused: " + FailureCodeName(refusal->code);
  std::string actions;
  for (const Task& task : std::get<TaskPlan>(understood).tasks) {
    actions += (actions.empty() ? "" : " ") + task.action;
    for (const Task& gesture : task.during) actions += "+" + gesture.action;
  }
  return actions;
}

struct UnderstoodCase {
  const char *text, *actions;
};

class UnderstoodTest : public testing::TestWithParam<UnderstoodCase> {};

TEST_P(UnderstoodTest, ClausesAreTasksInTheirOrder) {
  EXPECT_EQ(UnderstoodActions(GetParam().text), GetParam().actions) << GetParam().text;
}

INSTANTIATE_TEST_SUITE_P(Instructions, UnderstoodTest,
                         testing::ValuesIn(std::vector<UnderstoodCase>{
                             {"bow, then squat", "bow squat"},
                             {"squat after you bow", "bow squat"},
                             {"before you bow, squat", "squat bow"},
                             {"bow twice", "bow"},
                             {"turn left, twice", "turn turn"},
                             {"walk two steps while waving", "walk+wave"},
                             {"while you walk two steps, wave", "walk+wave"},
                             {"bow, no, squat", "squat"},
                             {"bow. do it again", "bow bow"},
                             {"鞠躬，然后下蹲", "bow squat"},
                         }));

TEST(Understand, ATextIsRefusedBeforeItIsReadWhereItIsNoInstruction) {
  const TaskScope scope = CorpusScope("nao");
  const auto code = [&](const std::string& text) {
    const auto understood = words::Understand(text, scope);
    return std::holds_alternative<words::Refusal>(understood) ? std::get<words::Refusal>(understood).code
                                                              : FailureCode::kInternal;
  };
  EXPECT_EQ(code(std::string(2001, 'a')), FailureCode::kRange);
  EXPECT_EQ(code("bow \x01"), FailureCode::kUnknown);
  EXPECT_EQ(code("{\"tasks\": []}"), FailureCode::kUnknown);
  EXPECT_EQ(code(""), FailureCode::kEmpty);
  EXPECT_EQ(code("please"), FailureCode::kEmpty);
}

TEST(Understand, WhatCannotBeDoneAtTheSameTimeIsRefused) {
  EXPECT_EQ(UnderstoodActions("squat while you walk two steps"), "refused: cannot");
}

TEST(Understand, TheLanguageIsThatOfTheText) {
  const TaskScope scope = CorpusScope("nao");
  EXPECT_EQ(words::UnderstandWords("bow", scope).value().language, "en");
  EXPECT_EQ(words::UnderstandWords("鞠躬", scope).value().language, "zh");
}

TEST(Understand, ARefusalIsAFailureWithItsCode) {
  const Result<TaskPlan> read = words::UnderstandWords("fly to the moon", CorpusScope("nao"));
  ASSERT_FALSE(read.ok());
  EXPECT_EQ(read.failure().kind, FailureKind::kBadInput);
}

TEST(Understand, WordsOfATaskAreThoseOfItsClause) {
  const TaskPlan plan = words::UnderstandWords("bow twice, then squat", CorpusScope("nao")).value();
  ASSERT_EQ(plan.tasks.size(), 2U);
  EXPECT_EQ(plan.text, "bow twice, then squat");
  EXPECT_EQ(plan.tasks[0].words, "bow twice");
  EXPECT_EQ(plan.tasks[1].words, "squat");
  EXPECT_EQ(plan.tasks[0].parameters.at("times"), TaskValue(2));
}

}  // namespace
}  // namespace gaitwright
