// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/base/file.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <thread>

#include "tests/kinematics/base/synced_files.h"
#include "tests/scratch_folder.h"

namespace gaitwright {
namespace {

namespace fs = std::filesystem;

class Files : public testing::Test {
 protected:
  Files() { fs::create_directories(folder_); }
  ~Files() override {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }

  std::string In(const std::string& name) const { return (folder_ / name).string(); }

  /// Every file and folder below, sorted.
  std::vector<std::string> Found() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(folder_))
      names.push_back(entry.path().lexically_relative(folder_).string());
    std::sort(names.begin(), names.end());
    return names;
  }

 private:
  fs::path folder_ = ScratchFolder() / testing::UnitTest::GetInstance()->current_test_info()->name();
};

TEST_F(Files, AreWrittenTogetherWithTheirFolders) {
  const auto written = WriteFilesTogether({{In("a/b/one"), "1"}, {In("two"), "2"}});
  ASSERT_TRUE(written) << written.failure().message;
  EXPECT_EQ(*written, (std::vector<std::string>{In("a/b/one"), In("two")}));
  EXPECT_EQ(Found(), (std::vector<std::string>{"a", "a/b", "a/b/one", "two"}));
  EXPECT_EQ(*ReadFile(In("a/b/one")), "1");
  ASSERT_TRUE(WriteFilesTogether({{In("two"), "new"}, {In("three"), "3"}}));
  EXPECT_EQ(*ReadFile(In("two")), "new");
  EXPECT_EQ(Found(), (std::vector<std::string>{"a", "a/b", "a/b/one", "three", "two"}));
}

TEST_F(Files, AreOnTheDiskBeforeTheyTakeTheirNamesAndTheirNamesWhenItIsDone) {
  const fs::path folder = fs::canonical(In("."));
  (void)TakeSyncedFiles();
  ASSERT_TRUE(WriteFilesTogether({{In("a/one"), "1"}, {In("two"), "2"}}));
  const std::vector<std::string> synced = TakeSyncedFiles();
  ASSERT_EQ(synced.size(), 4U);
  const std::string one = (folder / "a/one").string(), two = (folder / "two").string();
  EXPECT_TRUE(synced[0].starts_with(one + ".") && synced[0].ends_with(".part")) << synced[0];
  EXPECT_TRUE(synced[1].starts_with(two + ".") && synced[1].ends_with(".part")) << synced[1];
  EXPECT_EQ((std::vector<std::string>{synced[2], synced[3]}),
            (std::vector<std::string>{folder.string(), (folder / "a").string()}));
}

TEST_F(Files, OneThatCannotBeWrittenLeavesAllAsItWas) {
  ASSERT_TRUE(WriteFileAtomically(In("former"), "old"));
  fs::create_directories(In("folder"));
  const std::vector<std::string> before = Found();
  for (const std::string wrong : {"folder", "former/x", "former/x/y"}) {
    const auto written = WriteFilesTogether({{In("new/a"), "1"}, {In("former"), "2"}, {In(wrong), "3"}});
    ASSERT_FALSE(written) << wrong;
    EXPECT_NE(written.failure().message.find(In(wrong)), std::string::npos) << written.failure().message;
    EXPECT_EQ(Found(), before);
    EXPECT_EQ(*ReadFile(In("former")), "old");
  }
  const auto no_folder = WriteFilesTogether({{In("new/a"), "1"}, {"/proc/none/b", "2"}});
  ASSERT_FALSE(no_folder);
  EXPECT_EQ(no_folder.failure().code, FailureCode::kUnwritableFile);
  EXPECT_EQ(Found(), before);
}

TEST_F(Files, TheSystemsReasonIsSaidOfOneThatCannotBeMade) {
  const auto written = WriteFileAtomically("/proc/none", "text");  // where files cannot be created
  ASSERT_FALSE(written);
  const std::string begin = "cannot write '/proc/none': ";
  EXPECT_TRUE(written.failure().message.starts_with(begin)) << written.failure().message;
  EXPECT_GT(written.failure().message.size(), begin.size());
}

TEST_F(Files, OneNamedTwiceIsRefused) {
  const auto written = WriteFilesTogether({{In("a"), "1"}, {In("./a"), "2"}});
  ASSERT_FALSE(written);
  EXPECT_EQ(written.failure().code, FailureCode::kFileNamedTwice);
  EXPECT_TRUE(Found().empty());
}

/// The temporary file can be written, but not renamed, because there is a folder of that name. The files that were
/// renamed before are restored.
TEST_F(Files, AFailureWhileRenamingIsUndone) {
  ASSERT_TRUE(WriteFileAtomically(In("former"), "old"));
  const auto written = WriteFilesTogether({{In("new"), "1"}, {In("former"), "2"}, {In("x"), "3"}, {In("x/y"), "4"}});
  ASSERT_FALSE(written);
  EXPECT_EQ(Found(), std::vector<std::string>{"former"});
  EXPECT_EQ(*ReadFile(In("former")), "old");
}

TEST_F(Files, OnlyTextIsRead) {
  ASSERT_TRUE(WriteFileAtomically(In("latin"), "name: one\nname: caf\xe9\n"));
  const Result<std::string> latin = ReadFile(In("latin"));
  ASSERT_FALSE(latin);
  EXPECT_EQ(latin.failure().code, FailureCode::kNotText);
  EXPECT_NE(latin.failure().message.find("line 2 is not UTF-8 text: it contains an invalid byte 0xe9"),
            std::string::npos);
  ASSERT_TRUE(WriteFileAtomically(In("marked"), "\xef\xbb\xbfname: caf\xc3\xa9\n"));
  EXPECT_EQ(*ReadFile(In("marked")), "name: caf\xc3\xa9\n");
}

/// A program that receives a signal to end while it writes leaves complete files and no temporary ones.
TEST_F(Files, AnEndWhileWritingWaitsForWholeFiles) {
  const std::string text(8'000'000, 'x');
  const pid_t writer = fork();
  ASSERT_GE(writer, 0);
  if (writer == 0) {
    while (WriteFilesTogether({{In("a"), text}, {In("b"), text}})) {
    }
    _exit(1);
  }
  while (!fs::exists(In("b"))) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  std::this_thread::sleep_for(std::chrono::milliseconds(5));
  kill(writer, SIGTERM);
  int status = 0;
  waitpid(writer, &status, 0);
  EXPECT_TRUE(WIFSIGNALED(status));
  EXPECT_EQ(Found(), (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(fs::file_size(In("a")), text.size());
}

TEST_F(Files, DevicesAreLeftAlone) {
  EXPECT_FALSE(WriteFileAtomically("/dev/null", "text"));
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(Files, DevicesAreNotRead) {
  for (const char* device : {"/dev/zero", "/dev/null"}) {
    const Result<std::string> read = ReadBytes(device);
    ASSERT_FALSE(read) << device;
    EXPECT_EQ(read.failure().code, FailureCode::kNotAFile);
    EXPECT_NE(read.failure().message.find(device), std::string::npos);
  }
  EXPECT_EQ(ReadFile(In("")).failure().code, FailureCode::kNotAFile);
}

TEST_F(Files, NoMoreIsReadThanIsAskedFor) {
  ASSERT_TRUE(WriteFileAtomically(In("ten"), "0123456789"));
  EXPECT_EQ(*ReadBytes(In("ten"), 10), "0123456789");
  const Result<std::string> large = ReadFile(In("ten"), 9);
  ASSERT_FALSE(large);
  EXPECT_EQ(large.failure().code, FailureCode::kLargeFile);
  EXPECT_NE(large.failure().message.find("more than 9 bytes"), std::string::npos) << large.failure().message;
}

TEST_F(Files, AByteOfNothingIsNoText) {
  ASSERT_TRUE(WriteFileAtomically(In("nul"), std::string("a: 1\nb\0c", 8)));
  const Result<std::string> nul = ReadFile(In("nul"));
  ASSERT_FALSE(nul);
  EXPECT_NE(nul.failure().message.find("line 2 is not text: it contains a byte 0x00"), std::string::npos);
  EXPECT_EQ(ReadBytes(In("nul"))->size(), 8U);
}

}  // namespace
}  // namespace gaitwright
