// SPDX-License-Identifier: BSD-3-Clause
// State of a child when its program begins: files, limits, folder and group; and reasons why it cannot start.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <utility>

#include "tests/scratch_folder.h"
#include "workflows/sandbox/start_child_internal.h"

namespace gaitwright {
namespace {

class StartChildTest : public testing::Test {
 protected:
  StartChildTest() {
    folder_ = ScratchFolder() / testing::UnitTest::GetInstance()->current_test_info()->name();
    std::filesystem::create_directories(folder_);
    std::filesystem::permissions(folder_, std::filesystem::perms::all);
    setup_.program = "/bin/sh";
    setup_.work_folder = folder_.string();
    setup_.environment = {"PATH=/usr/bin:/bin"};
    setup_.confined = false;
    EXPECT_EQ(pipe2(reads_.data(), O_CLOEXEC), 0);
    EXPECT_EQ(pipe2(writes_.data(), O_CLOEXEC), 0);
  }
  ~StartChildTest() override {
    for (const int end : {reads_[0], reads_[1], writes_[0], writes_[1]})
      if (end >= 0) close(end);
  }

  Result<pid_t> Start(const std::string& script) {
    setup_.arguments = {"-c", script};
    return StartChild(setup_, reads_[0], writes_[1]);
  }

  /// The text that a script writes to its file 4, and its exit status.
  std::string Said(const std::string& script, int* status = nullptr) {
    const Result<pid_t> child = Start(script);
    if (!child) {
      ADD_FAILURE() << child.failure().message;
      return "";
    }
    close(std::exchange(writes_[1], -1));
    std::string said;
    std::array<char, 256> piece{};
    for (ssize_t n = 0; (n = read(writes_[0], piece.data(), piece.size())) > 0;)
      said.append(piece.data(), static_cast<std::size_t>(n));
    int ended = 0;
    waitpid(*child, &ended, 0);
    if (status != nullptr) *status = ended;
    return said;
  }

  ChildSetup setup_;
  std::filesystem::path folder_;
  std::array<int, 2> reads_{-1, -1}, writes_{-1, -1};
};

TEST_F(StartChildTest, TheProgramRunsWithItsArguments) {
  int status = 0;
  EXPECT_EQ(Said("echo one two >&4; exit 5", &status), "one two\n");
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 5);
}

TEST_F(StartChildTest, ItReadsWhatIsSentToIt) {
  ASSERT_EQ(write(reads_[1], "hello\n", 6), 6);
  EXPECT_EQ(Said("read line <&3; echo \"<$line>\" >&4"), "<hello>\n");
}

// Files 0 to 2 are /dev/null, so that its output is discarded.
TEST_F(StartChildTest, ItsUsualFilesAreNothing) {
  EXPECT_EQ(Said("echo lost; echo lost >&2; if read line; then echo read >&4; else echo end >&4; fi"), "end\n");
}

TEST_F(StartChildTest, OnlyThePipesAreOpenBesides) {
  const int open_here = open("/dev/null", O_RDONLY);  // without O_CLOEXEC: a child would inherit it
  ASSERT_GE(open_here, 5);
  const std::string script =
      "for f in /proc/self/fd/*; do n=${f##*/}; [ $n -gt 2 ] && [ -e /proc/$$/fd/$n ] && echo $n >&4; done; true";
  EXPECT_EQ(Said(script), "3\n4\n");
  close(open_here);
}

TEST_F(StartChildTest, LimitsAreThoseOfItsSetup) {
  setup_.limits.memory_mb = 512;
  setup_.limits.time_s = 2.5;
  EXPECT_EQ(Said("{ ulimit -n; ulimit -c; ulimit -v; ulimit -t; } >&4"), "64\n0\n524288\n3\n")
      << "files, dumps, kB of address space, seconds in whole ones";
}

TEST_F(StartChildTest, ItIsALeaderOfASessionOfItsOwn) {
  EXPECT_EQ(Said("read a b c d e s rest < /proc/$$/stat; [ $s = $$ ] && echo own >&4"), "own\n");
}

TEST_F(StartChildTest, AFolderOrProgramThatIsNotThereIsNamed) {
  const auto refused = [&](const std::string& named) {
    const Result<pid_t> child = Start("exit 0");
    ASSERT_FALSE(child.ok());
    EXPECT_EQ(child.failure().kind, FailureKind::kBadInput);
    EXPECT_EQ(child.failure().code, FailureCode::kChild);
    EXPECT_NE(child.failure().message.find("('" + named + "')"), std::string::npos) << child.failure().message;
  };
  setup_.work_folder = "/nowhere/at/all";
  refused("/nowhere/at/all");
  setup_.work_folder = folder_.string();
  setup_.program = "/nowhere/program";
  refused("/nowhere/program");
}

}  // namespace
}  // namespace gaitwright
