// SPDX-License-Identifier: BSD-3-Clause
// A language model for instructions, simulated by a stand-in on the loopback address: with good, bad, dangerous, slow
// and missing answers.
#include "workflows/words/interpret.h"

#include <gtest/gtest.h>

#include "tests/workflows/words/corpus.h"
#include "tests/workflows/words/fake_model.h"

namespace gaitwright {
namespace {

using Kind = FakeAnswer::Kind;

const char* const kGood = R"({"schema": 1, "tasks": [{"action": "wave", "side": "left", "words": "say hi"}]})";

LanguageModel ModelAt(const FakeModel& fake) { return {fake.url(), "a-model", "secret", 2.0}; }

TEST(Interpret, AGoodAnswerIsTaken) {
  const FakeModel fake({{Kind::kContent, std::string("Here it is:\n```json\n") + kGood + "\n```\n", 200}});
  const Result<Interpretation> made = Interpret("greet them with the other hand", CorpusScope("nao"), ModelAt(fake));
  ASSERT_TRUE(made.ok()) << made.failure().message;
  EXPECT_EQ(made->by, "language model");
  ASSERT_EQ(made->plan.tasks.size(), 1U);
  EXPECT_EQ(made->plan.tasks[0].Word("side"), "left");
  EXPECT_EQ(made->plan.text, "greet them with the other hand");
  const std::vector<std::string> requests = fake.requests();
  ASSERT_EQ(requests.size(), 1U);
  EXPECT_NE(requests[0].find("POST /v1/chat/completions"), std::string::npos);
  EXPECT_NE(requests[0].find("Bearer secret"), std::string::npos);
  EXPECT_NE(requests[0].find("a-model"), std::string::npos);
  EXPECT_NE(requests[0].find("red marker"), std::string::npos);  // the prompt has the places and the robot's abilities
  EXPECT_EQ(requests[0].find("lie_down"), std::string::npos);
}

TEST(Interpret, ABadAnswerIsAskedForOnceMoreWithTheError) {
  const FakeModel fake({{Kind::kContent, R"({"schema": 1, "tasks": [{"action": "wave", "side": "up"}]})", 200},
                        {Kind::kContent, kGood, 200}});
  const Result<Interpretation> made = Interpret("say hi", CorpusScope("nao"), ModelAt(fake));
  ASSERT_TRUE(made.ok()) << made.failure().message;
  EXPECT_EQ(made->by, "language model");
  ASSERT_EQ(made->notes.size(), 1U);
  EXPECT_NE(made->notes[0].find("is 'up'"), std::string::npos) << made->notes[0];
  ASSERT_EQ(fake.requests().size(), 2U);
  EXPECT_NE(fake.requests()[1].find("That is not valid"), std::string::npos);
}

/// An answer that is not valid for this robot is never accepted; the grammar is used instead.
TEST(Interpret, DangerousAnswersAreNeverTaken) {
  for (const char* dangerous :
       {R"({"schema": 1, "tasks": [{"action": "walk", "direction": "forward", "distance_m": 100000}]})",
        R"({"schema": 1, "tasks": [{"action": "walk", "direction": "forward", "speed_m_s": 40}]})",
        R"({"schema": 1, "tasks": [{"action": "lie_down"}]})",
        R"({"schema": 1, "tasks": [{"action": "shell", "command": "rm -rf /"}]})",
        R"({"schema": 1, "tasks": [{"action": "bow", "angle_deg": 1e999}]})",
        R"({"schema": 1, "tasks": [{"action": "walk", "direction": "forward", "to": {"name": "street"}}]})",
        R"({"schema": 1, "tasks": []})", "{", "", "I cannot do that.", "[1, 2, 3]"}) {
    const FakeModel fake({{Kind::kContent, dangerous, 200}});
    const Result<Interpretation> made = Interpret("bow twice", CorpusScope("nao"), ModelAt(fake));
    ASSERT_TRUE(made.ok()) << dangerous << made.failure().message;
    EXPECT_EQ(made->by, "grammar") << dangerous;
    EXPECT_EQ(made->plan.tasks[0].action, "bow");
    EXPECT_EQ(made->notes.size(), 2U) << dangerous;
    EXPECT_EQ(fake.requests().size(), 2U);
  }
}

TEST(Interpret, NoAnswerLeavesItToTheGrammar) {
  for (const FakeAnswer& answer : std::vector<FakeAnswer>{{Kind::kSilence, "", 200},
                                                          {Kind::kHangUp, "", 200},
                                                          {Kind::kStatus, "", 503},
                                                          {Kind::kBody, "{}", 200},
                                                          {Kind::kBody, "no JSON", 200},
                                                          {Kind::kBody, R"({"choices": []})", 200},
                                                          {Kind::kBody, R"({"choices": [{"message": 1}]})", 200},
                                                          {Kind::kBody, std::string(2 << 20, 'x'), 200}}) {
    const FakeModel fake({answer});
    LanguageModel model = ModelAt(fake);
    model.longest_s = 0.5;
    const Result<Interpretation> made = Interpret("bow twice", CorpusScope("nao"), model);
    ASSERT_TRUE(made.ok()) << made.failure().message;
    EXPECT_EQ(made->by, "grammar");
    ASSERT_EQ(made->notes.size(), 1U);
    EXPECT_NE(made->notes[0].find("did not answer"), std::string::npos);
  }
}

TEST(Interpret, WhereNobodyUnderstandsItIsRefusedWithBothReasons) {
  const FakeModel fake({{Kind::kContent, R"({"schema": 1, "tasks": []})", 200}});
  const Result<Interpretation> made = Interpret("juggle three balls", CorpusScope("nao"), ModelAt(fake));
  ASSERT_FALSE(made.ok());
  EXPECT_EQ(made.failure().code, FailureCode::kUnknown);
  EXPECT_NE(made.failure().message.find("'juggle three balls'"), std::string::npos);
  bool named = false;
  for (const Suggestion& suggestion : made.failure().suggestions)
    named = named || suggestion.text.find("the plan contains no task") != std::string::npos;
  EXPECT_TRUE(named);
}

TEST(Interpret, OnlyHttpIsSpoken) {
  for (const char* url : {"file:///etc/passwd", "ftp://localhost/", "localhost:8000", ""}) {
    const Result<Interpretation> made = Interpret("bow", CorpusScope("nao"), LanguageModel{url, "m", "", 1.0});
    ASSERT_FALSE(made.ok()) << url;
    EXPECT_EQ(made.failure().code, FailureCode::kInterpreterUrl);
  }
}

/// A user's own interpreter can be used besides the two built-in ones.
class OneWord : public Interpreter {
 public:
  std::string name() const override { return "one word"; }
  Result<TaskPlan> Interpret(const std::string& instruction, const TaskScope&,
                             std::vector<std::string>& notes) const override {
    if (instruction == "salaam") {
      TaskPlan plan;
      plan.tasks = {Task{"bow", {}, "salaam", {}}};
      return plan;
    }
    notes.push_back("it is not the one word");
    return Failure{FailureKind::kBadInput, FailureCode::kUnknown, "OneWord", "unknown", {}};
  }
};

TEST(InterpretBy, TheFirstThatUnderstandsIsTaken) {
  const OneWord one_word;
  const Grammar grammar;
  const auto by = [&](const std::string& text) {
    const Result<Interpretation> made = InterpretBy({&one_word, &grammar}, text, CorpusScope("nao"));
    return made.ok() ? made->by : FailureCodeName(made.failure().code);
  };
  EXPECT_EQ(by("salaam"), "one word");
  EXPECT_EQ(by("bow"), "grammar");
  EXPECT_EQ(by("juggle"), "unknown");
  const Result<Interpretation> made = InterpretBy({&one_word, &grammar}, "bow", CorpusScope("nao"));
  EXPECT_EQ(made->notes, std::vector<std::string>{"it is not the one word"});
  EXPECT_THROW((void)InterpretBy({}, "bow", CorpusScope("nao")), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
