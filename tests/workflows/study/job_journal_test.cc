// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/job_journal.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/scratch_folder.h"

namespace gaitwright {
namespace {

namespace fs = std::filesystem;

class Journals : public testing::Test {
 protected:
  Journals() : path_(ScratchFile("journal.so-far")) { fs::remove(path_); }
  ~Journals() override { fs::remove(path_); }

  std::string Text() const {
    std::ostringstream text;
    text << std::ifstream(path_).rdbuf();
    return text.str();
  }
  void Write(const std::string& text) const { std::ofstream(path_) << text; }
  Result<JobJournal> Open(const std::string& identity, bool resume) const {
    return JobJournal::Open(path_.string(), identity, resume);
  }
  void ExpectRefused(bool resume, const std::string& part) const {
    const Result<JobJournal> journal = Open("work", resume);
    ASSERT_FALSE(journal);
    EXPECT_NE(journal.failure().message.find(part), std::string::npos) << journal.failure().message;
    EXPECT_NE(journal.failure().message.find(path_.string()), std::string::npos);
  }

  fs::path path_;
};

TEST_F(Journals, WhatWasAddedIsFoundAgain) {
  {
    Result<JobJournal> journal = Open("work", false);
    ASSERT_TRUE(journal) << journal.failure().message;
    journal->Add(7, "seven");
    journal->Add(2, "{\"two\": 2}");
  }
  const Result<JobJournal> again = Open("work", true);
  ASSERT_TRUE(again) << again.failure().message;
  EXPECT_EQ(again->found(), 2U);
  EXPECT_EQ(again->found(2), 2U);
  EXPECT_EQ(again->found(3), 1U);
  EXPECT_EQ(again->found(8), 0U);
  EXPECT_EQ(again->Find(7), "seven");
  EXPECT_EQ(again->Find(2), "{\"two\": 2}");
  EXPECT_EQ(again->Find(3), std::nullopt);
}

TEST_F(Journals, ALineThatWasCutShortIsDoneAgain) {
  Write("gaitwright journal of work\n1 one\n2 tw");
  {
    Result<JobJournal> journal = Open("work", true);
    ASSERT_TRUE(journal) << journal.failure().message;
    EXPECT_EQ(journal->found(), 1U);
    journal->Add(2, "two");
  }
  EXPECT_EQ(Text(), "gaitwright journal of work\n1 one\n2 two\n");
}

TEST_F(Journals, OneThatWasCutInItsHeadIsBegunAnew) {
  Write("gaitwright jour");
  const Result<JobJournal> journal = Open("work", true);
  ASSERT_TRUE(journal) << journal.failure().message;
  EXPECT_EQ(Text(), "gaitwright journal of work\n");
}

TEST_F(Journals, OneWithoutAResultIsAsNone) {
  for (const char* text :
       {"gaitwright journal of other\n", "gaitwright journal of work\n7 sev", "gaitwright jour", ""}) {
    for (const bool resume : {false, true}) {
      Write(text);
      const Result<JobJournal> journal = Open("work", resume);
      ASSERT_TRUE(journal) << journal.failure().message;
      EXPECT_EQ(journal->found(), 0U);
      EXPECT_EQ(Text(), "gaitwright journal of work\n");
    }
    EXPECT_FALSE(fs::exists(path_)) << "nothing was added to it";
  }
}

TEST_F(Journals, RefusalsSayWhy) {
  Write("gaitwright journal of other\n1 one\n");
  ExpectRefused(false, "contains an unfinished run");
  ExpectRefused(true, "belongs to another run");
  for (const char* strange : {"something else\n", "something else"}) {
    Write(strange);
    ExpectRefused(true, "is not a journal of this program");
    ExpectRefused(false, "is not a journal of this program");
    EXPECT_EQ(Text(), strange);
  }
  Write("gaitwright journal of work\n1 one\nxyz\n3 three\n");
  ExpectRefused(true, "is damaged in line 3");
  EXPECT_EQ(Text(), "gaitwright journal of work\n1 one\nxyz\n3 three\n") << "a refused file is left as it is";
}

/// Lines of this size as holes in the file, which need no space on the disk.
void WriteLongLines(const fs::path& path, std::size_t count, std::size_t bytes) {
  std::ofstream file(path, std::ios::binary);
  file << "gaitwright journal of work\n";
  for (std::size_t i = 0; i < count; ++i) {
    file << i << " begin";
    file.seekp(static_cast<std::streamoff>(bytes), std::ios::cur);
    file << "end\n";
  }
}

TEST_F(Journals, OneLargerThanAnyOtherFileIsReadToo) {
  constexpr std::size_t kLines = 45, kBytes = std::size_t{12} << 20;
  WriteLongLines(path_, kLines, kBytes);
  ASSERT_GT(fs::file_size(path_), std::uintmax_t{512} << 20);
  const Result<JobJournal> journal = Open("work", true);
  ASSERT_TRUE(journal) << journal.failure().message;
  EXPECT_EQ(journal->found(), kLines);
  const std::string last = journal->Find(kLines - 1).value();
  EXPECT_EQ(last.size(), kBytes + 8);
  EXPECT_TRUE(last.starts_with("begin") && last.ends_with("end"));
}

TEST_F(Journals, ALineWithoutEndIsRefused) {
  WriteLongLines(path_, 1, std::size_t{17} << 20);
  ExpectRefused(true, "has a line of more than 16777216 bytes");
}

TEST_F(Journals, ALineThatCannotBeWrittenLeavesTheOthersWhole) {
  Result<JobJournal> journal = Open("work", false);
  ASSERT_TRUE(journal);
  journal->Add(1, "one");
  const std::string good = Text();
  rlimit before = {}, few = {};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  few = before;
  few.rlim_cur = good.size() + 4;  // simulates a full disk
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &few), 0);
  std::string why;
  try {
    journal->Add(2, "a longer line");
  } catch (const CannotKeep& error) {
    why = error.what();
  }
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_NE(why.find("cannot keep intermediate results in '" + path_.string()), std::string::npos) << why;
  EXPECT_EQ(Text(), good);
  EXPECT_THROW(journal->Add(3, "three"), CannotKeep) << "what came after it would be lost without a word";
  EXPECT_EQ(Text(), good);
}

TEST_F(Journals, OneProcessHoldsItAndTheEndRemovesIt) {
  Result<JobJournal> journal = Open("work", false);
  ASSERT_TRUE(journal);
  ExpectRefused(true, "is being written by another process");
  journal->Remove();
  EXPECT_FALSE(fs::exists(path_));
}

}  // namespace
}  // namespace gaitwright
