// SPDX-License-Identifier: BSD-3-Clause
// Random changes of task plans and instructions: nothing crashes, and no value out of range is accepted.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "planning/tasks/task_plan_json.h"
#include "tests/workflows/words/corpus.h"
#include "workflows/words/interpret.h"
#include "workflows/words/understand.h"

namespace gaitwright {
namespace {

/// Checks a task against the rules, independently of the code under test.
void ExpectWithinRules(const Task& task) {
  const ActionRule* rule = FindAction(task.action);
  ASSERT_NE(rule, nullptr);
  for (const auto& [key, value] : task.parameters) {
    const ParameterRule* parameter = FindParameter(key);
    ASSERT_NE(parameter, nullptr) << key;
    if (const auto* number = std::get_if<double>(&value)) {
      EXPECT_TRUE(std::isfinite(*number));
      EXPECT_GE(*number, parameter->lowest) << key;
      EXPECT_LE(*number, parameter->highest) << key;
    } else if (const auto* count = std::get_if<int>(&value)) {
      EXPECT_GE(*count, parameter->lowest) << key;
      EXPECT_LE(*count, parameter->highest) << key;
    } else if (const auto* word = std::get_if<std::string>(&value)) {
      EXPECT_NE(std::find(parameter->words.begin(), parameter->words.end(), *word), parameter->words.end()) << *word;
    }
  }
  for (const Task& gesture : task.during) ExpectWithinRules(gesture);
}

class Mutator {
 public:
  explicit Mutator(unsigned seed) : random_(seed) {}

  std::string Mutated(std::string text) {
    const int changes = 1 + Below(4);
    for (int k = 0; k < changes && !text.empty(); ++k) Change(text);
    return text;
  }

 private:
  int Below(std::size_t n) { return static_cast<int>(std::uniform_int_distribution<std::size_t>(0, n - 1)(random_)); }

  void Change(std::string& text) {
    static const std::vector<std::string> kParts = {"1e308", "-1",           "NaN",    "null",  "\"walk\"", "[]",
                                                    "{}",    "999999999999", "0.0",    "true",  "\"",       ",",
                                                    ":",     "\\u0000",      "while",  "tasks", "-0.5",     "1e-9",
                                                    "向前",  "然后",         " then ", "不",    "3 m",      " and "};
    const auto at = static_cast<std::size_t>(Below(text.size()));
    switch (Below(5)) {
      case 0:
        text[at] = static_cast<char>(Below(256));
        break;
      case 1:
        text.erase(at, static_cast<std::size_t>(1 + Below(8)));
        break;
      case 2:
        text.insert(at, kParts[static_cast<std::size_t>(Below(kParts.size()))]);
        break;
      case 3:
        text.insert(at, text.substr(static_cast<std::size_t>(Below(text.size())), static_cast<std::size_t>(Below(30))));
        break;
      default: {
        const std::size_t digit = text.find_first_of("0123456789", at);
        if (digit != std::string::npos) text.replace(digit, 1, kParts[static_cast<std::size_t>(Below(kParts.size()))]);
      }
    }
  }

  std::mt19937 random_;
};

TEST(MutatedTaskPlans, NoneOutOfRangeIsLetPass) {
  constexpr int kPlans = 10000;
  const auto corpus = LoadCorpus("corpus.yaml");
  Mutator mutator(1);
  int let_pass = 0, refused = 0;
  for (int k = 0; k < kPlans; ++k) {
    const CorpusEntry& entry = corpus[static_cast<std::size_t>(k) % corpus.size()];
    const TaskScope scope = CorpusScope(entry.robot);
    const Result<TaskPlan> plan = PlanInAnswer(mutator.Mutated(TasksText(entry.tasks)), entry.text, scope);
    (plan ? let_pass : refused)++;
    if (!plan) {
      EXPECT_FALSE(plan.failure().message.empty());
      continue;
    }
    for (const Task& task : plan->tasks) {
      ExpectWithinRules(task);
      EXPECT_FALSE(ReasonNotDone(task, scope));
    }
  }
  EXPECT_GT(let_pass, kPlans / 50);  // harmless changes are accepted
  EXPECT_GT(refused, kPlans / 2);
}

TEST(MutatedInstructions, NeverCrashNorGoOutOfRange) {
  constexpr int kInstructions = 10000;
  auto corpus = LoadCorpus("corpus.yaml");
  for (const CorpusEntry& entry : LoadCorpus("further.yaml")) corpus.push_back(entry);
  Mutator mutator(2);
  int understood = 0;
  for (int k = 0; k < kInstructions; ++k) {
    const CorpusEntry& entry = corpus[static_cast<std::size_t>(k) % corpus.size()];
    const auto answer = words::Understand(mutator.Mutated(entry.text), CorpusScope(entry.robot));
    if (const auto* plan = std::get_if<TaskPlan>(&answer)) {
      ++understood;
      for (const Task& task : plan->tasks) ExpectWithinRules(task);
    } else {
      EXPECT_NE(std::get<words::Refusal>(answer).code, FailureCode::kInternal);
    }
  }
  EXPECT_GT(understood, 100);
}

}  // namespace
}  // namespace gaitwright
