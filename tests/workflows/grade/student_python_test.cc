// SPDX-License-Identifier: BSD-3-Clause
// A submission in its own process: requests, answers, and how its text is shown.
#include "workflows/grade/student_python.h"

#include <gtest/gtest.h>

#include "tests/workflows/grade/made_class.h"

namespace gaitwright {
namespace {

TEST(ShownWords, AreOneLineOfPlainText) {
  EXPECT_EQ(ShownWords("a\nb\tc\rd"), "a b c d");
  EXPECT_EQ(ShownWords("bell \x07 and \x7f"), "bell ? and ?");
  EXPECT_EQ(ShownWords("plain <text> & more"), "plain <text> & more");
}

TEST(ShownWords, HaveNoAddressesOfMemory) {
  EXPECT_EQ(ShownWords("<object at 0x7f3a5c001234>"), "<object at 0x...>");
  EXPECT_EQ(ShownWords("0xff is short"), "0xff is short") << "a number of the student's";
}

// Byte 400 is inside the 134th character of three bytes.
TEST(ShownWords, EndBetweenCharacters) {
  std::string words, shown;
  for (int i = 0; i < 200; ++i) words += "\u932f";
  for (int i = 0; i < 133; ++i) shown += "\u932f";
  EXPECT_EQ(ShownWords(words), shown);
}

TEST(ShownWords, AreShort) { EXPECT_EQ(ShownWords(std::string(1000, 'x')), std::string(400, 'x')); }

TEST(EndedIt, OnlyWhatTheSubmissionSaysLeavesItRunning) {
  const auto failure = [](FailureCode code) { return Failure{FailureKind::kBadInput, code, "", "", {}}; };
  EXPECT_FALSE(EndedIt(failure(FailureCode::kSubmission)));
  for (const FailureCode code : {FailureCode::kChildEnded, FailureCode::kChildTime, FailureCode::kChildAnswer})
    EXPECT_TRUE(EndedIt(failure(code)));
}

/// A submission that runs with resource limits only, without confinement.
class StudentPythonTest : public testing::Test {
 protected:
  void SetUp() override {
    const Result<PythonProgram> found = LookOver("");
    if (!found) GTEST_SKIP() << found.failure().message;
    python_ = *found;
  }
  Result<StudentPython> Started(const std::string& code) const {
    return StudentPython::Start(python_, {{{"work.py", code}}, "answer"}, {}, false);
  }

  PythonProgram python_;
};

TEST_F(StudentPythonTest, AnExceptionOfItsFileIsReported) {
  const Result<StudentPython> started = Started("raise ValueError('not today')\n");
  ASSERT_FALSE(started.ok());
  EXPECT_EQ(started.failure().code, FailureCode::kSubmission);
  EXPECT_NE(started.failure().message.find("not today"), std::string::npos) << started.failure().message;
}

TEST_F(StudentPythonTest, AFileWithoutItsFunctionIsRefused) {
  const Result<StudentPython> started = Started("x = 1\n");
  ASSERT_FALSE(started.ok());
  EXPECT_NE(started.failure().message.find("answer"), std::string::npos) << started.failure().message;
}

TEST_F(StudentPythonTest, AFileIsLentWithItsText) {
  Result<StudentPython> started = Started("def answer(x):\n    return x\n");
  ASSERT_TRUE(started.ok()) << started.failure().message;
  const Result<std::string> path = started->Lend("plan.json", "{}");
  ASSERT_TRUE(path.ok()) << path.failure().message;
  EXPECT_EQ(ReadFile(*path).value(), "{}");
}

}  // namespace
}  // namespace gaitwright
