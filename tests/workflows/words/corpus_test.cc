// SPDX-License-Identifier: BSD-3-Clause
// The built-in grammar is tested with instructions that were written before it.
#include "tests/workflows/words/corpus.h"

#include <gtest/gtest.h>

#include "workflows/words/understand.h"

namespace gaitwright {
namespace {

/// Number of instructions of a corpus that are understood correctly; with `all`, each of the others is a test failure.
int Understood(const std::vector<CorpusEntry>& corpus, bool all) {
  int count = 0;
  for (const CorpusEntry& entry : corpus) {
    const auto understood = words::Understand(entry.text, CorpusScope(entry.robot, entry.ground));
    const auto* plan = std::get_if<TaskPlan>(&understood);
    const bool as_meant = plan != nullptr && TasksText(plan->tasks) == TasksText(entry.tasks);
    count += as_meant ? 1 : 0;
    if (as_meant || !all) continue;
    const auto* refusal = std::get_if<words::Refusal>(&understood);
    ADD_FAILURE() << entry.text << "\nmeans " << TasksText(entry.tasks) << "\nis taken as "
                  << (plan != nullptr ? TasksText(plan->tasks) : FailureCodeName(refusal->code) + ": " + refusal->part);
  }
  return count;
}

TEST(Corpus, IsUnderstood) {
  ASSERT_GE(LoadCorpus("corpus.yaml").size(), 120U);
  for (const char* file : {"corpus.yaml", "further.yaml", "third.yaml", "later.yaml"}) {
    const auto corpus = LoadCorpus(file);
    EXPECT_EQ(Understood(corpus, true), static_cast<int>(corpus.size())) << file;
  }
}

/// The share of understood instructions must not decrease, both for the corpora used to improve the grammar and for
/// unseen ones.
TEST(Corpus, MostIsUnderstoodHoweverPeopleTalk) {
  const auto further = LoadCorpus("fourth.yaml"), held_back = LoadCorpus("held_back.yaml");
  ASSERT_GE(further.size(), 400U);
  ASSERT_GE(held_back.size(), 40U);
  const int understood = Understood(further, false), unseen = Understood(held_back, false);
  RecordProperty("understood", understood);
  RecordProperty("unseen", unseen);
  EXPECT_GE(understood, 0.95 * static_cast<double>(further.size())) << understood << " of " << further.size();
  EXPECT_GE(unseen, 0.85 * static_cast<double>(held_back.size())) << unseen << " of " << held_back.size();
}

/// Removing reasons and actions of other people must not remove conditions, objects and actions that no robot can do.
TEST(Corpus, NothingThatMattersIsLeftOut) {
  const auto refusals = LoadRefusals("not_understood.yaml");
  ASSERT_GE(refusals.size(), 120U);
  for (const RefusalEntry& entry : refusals) {
    const auto understood = words::Understand(entry.text, CorpusScope(entry.robot, entry.ground));
    const auto* plan = std::get_if<TaskPlan>(&understood);
    EXPECT_EQ(plan, nullptr) << entry.text << "\nis taken as " << TasksText(plan->tasks);
  }
}

TEST(Corpus, WhatIsNotAcceptedIsRefusedByItsPart) {
  std::vector<RefusalEntry> refusals = LoadRefusals("refusals.yaml");
  ASSERT_GE(refusals.size(), 60U);
  const auto later = LoadRefusals("later_refusals.yaml");
  refusals.insert(refusals.end(), later.begin(), later.end());
  for (const RefusalEntry& entry : refusals) {
    const auto understood = words::Understand(entry.text, CorpusScope(entry.robot, entry.ground));
    const auto* refusal = std::get_if<words::Refusal>(&understood);
    ASSERT_NE(refusal, nullptr) << entry.text;
    EXPECT_EQ(FailureCodeName(refusal->code), entry.reason) << entry.text;
    EXPECT_EQ(refusal->part, entry.part) << entry.text;
    if (!entry.nearest.empty()) {
      EXPECT_EQ(refusal->nearest, entry.nearest) << entry.text;
    }
  }
}

/// Each task has the words that it comes from.
TEST(Corpus, WordsAreKept) {
  const auto understood = words::Understand("Please walk two steps, then raise the right arm.", CorpusScope("nao"));
  const auto* plan = std::get_if<TaskPlan>(&understood);
  ASSERT_NE(plan, nullptr);
  ASSERT_EQ(plan->tasks.size(), 2U);
  EXPECT_EQ(plan->tasks[0].words, "walk two steps");
  EXPECT_EQ(plan->tasks[1].words, "raise the right arm");
  EXPECT_EQ(plan->language, "en");
  const auto both = words::Understand("鞠躬，然后一边走一边挥手", CorpusScope("nao"));
  ASSERT_TRUE(std::holds_alternative<TaskPlan>(both));
  const Task& walk = std::get<TaskPlan>(both).tasks.at(1);
  EXPECT_EQ(walk.words, "一边走一边挥手");
  EXPECT_EQ(walk.during.at(0).words, "挥手");
}

/// A forbidden action is not carried out.
TEST(Grammar, WhatIsNotToBeDoneIsNotDone) {
  const auto tasks = [](const std::string& text) {
    const auto understood = words::Understand(text, CorpusScope("a1"));
    const auto* plan = std::get_if<TaskPlan>(&understood);
    if (plan == nullptr) return std::string("refused");
    std::string names;
    for (const Task& task : plan->tasks) names += task.action + " ";
    return names;
  };
  EXPECT_EQ(tasks("Don't walk."), "refused");
  EXPECT_EQ(tasks("Sit. Don't walk."), "refused");
  EXPECT_EQ(tasks("Walk one metre. No, don't walk, sit."), "sit ");
  EXPECT_EQ(tasks("坐下，算了，别坐了，趴下。"), "lie_down ");
}

}  // namespace
}  // namespace gaitwright
