// SPDX-License-Identifier: BSD-3-Clause
// Shells as child processes: requests, answers and ends. Confinement is tested elsewhere.
#include "workflows/sandbox/child_process.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/scratch_folder.h"

namespace gaitwright {
namespace {

/// A shell that runs a script with resource limits only.
class ChildShell : public testing::Test {
 protected:
  ChildShell() {
    folder_ = ScratchFolder() / testing::UnitTest::GetInstance()->current_test_info()->name();
    std::filesystem::create_directories(folder_);
    std::filesystem::permissions(folder_, std::filesystem::perms::all);
    setup_.program = "/bin/sh";
    setup_.work_folder = folder_.string();
    setup_.confined = false;
  }

  ChildProcess Started(const std::string& script) {
    setup_.arguments = {"-c", script};
    Result<ChildProcess> child = ChildProcess::Start(setup_);
    if (!child) throw std::runtime_error(child.failure().message);
    return std::move(*child);
  }

  ChildSetup setup_;
  std::filesystem::path folder_;
};

constexpr char kEcho[] = "while read line <&3; do echo \"<$line>\" >&4; done";

TEST_F(ChildShell, AnswersLineByLine) {
  ChildProcess child = Started(kEcho);
  for (const std::string line : {"one", "two words", ""}) {
    const Result<std::string> answer = child.Ask(line, 100);
    ASSERT_TRUE(answer.ok()) << answer.failure().message;
    EXPECT_EQ(*answer, "<" + line + ">");
  }
}

TEST_F(ChildShell, TwoLinesAtOnceAreTwoAnswers) {
  ChildProcess child = Started("read a <&3; printf 'first\\nsecond\\n' >&4; read b <&3; sleep 5");
  EXPECT_EQ(child.Ask("x", 100).value(), "first");
  EXPECT_EQ(child.Ask("y", 100).value(), "second");
}

TEST_F(ChildShell, OneThatEndsIsAFailureAndStaysOne) {
  ChildProcess child = Started("read a <&3; exit 3");
  const Result<std::string> answer = child.Ask("x", 100);
  ASSERT_FALSE(answer.ok());
  EXPECT_EQ(answer.failure().kind, FailureKind::kBadInput);
  EXPECT_EQ(answer.failure().code, FailureCode::kChildEnded);
  EXPECT_EQ(child.Ask("y", 100).failure(), answer.failure()) << "the same again";
}

TEST_F(ChildShell, AnAnswerThatIsTooLongIsRefused) {
  ChildProcess child = Started(kEcho);
  EXPECT_TRUE(child.Ask(std::string(98, 'x'), 100).ok());
  const Result<std::string> answer = child.Ask(std::string(200, 'x'), 100);
  ASSERT_FALSE(answer.ok());
  EXPECT_EQ(answer.failure().code, FailureCode::kChildAnswer);
}

TEST_F(ChildShell, HasNoOtherVariablesAndWorksInItsFolder) {
  setup_.environment = {"ONLY=this"};
  ChildProcess child = Started("read a <&3; echo \"$ONLY ${HOME:-no home} $PWD\" >&4; read b <&3");
  EXPECT_EQ(child.Ask("x", 1000).value(), "this no home " + std::filesystem::canonical(folder_).string());
}

TEST_F(ChildShell, AProgramThatIsNotThereCannotAnswer) {
  setup_.program = "/nowhere/program";
  Result<ChildProcess> child = ChildProcess::Start(setup_);
  if (child) {
    EXPECT_FALSE(child->Ask("x", 100).ok());
  } else {
    EXPECT_EQ(child.failure().code, FailureCode::kChild);
  }
}

TEST(ChildLimitsOfTime, AChildMaySleepTenSecondsLongerThanItMayCompute) {
  ChildLimits limits;
  limits.time_s = 2.5;
  EXPECT_EQ(limits.longest_sleep_s(), 12.5);
  limits.time_s = 0.0;
  EXPECT_THROW(CheckOptions(limits.Fields()), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
