// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/job_journal.h"

#include <gtest/gtest.h>

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

TEST_F(Journals, RefusalsSayWhy) {
  Write("gaitwright journal of other\n");
  ExpectRefused(false, "holds work that was not finished");
  ExpectRefused(true, "is of other work");
  Write("something else\n");
  ExpectRefused(true, "is no journal of this program");
  Write("gaitwright journal of work\n1 one\nxyz\n3 three\n");
  ExpectRefused(true, "is broken in line 3");
  EXPECT_EQ(Text(), "gaitwright journal of work\n1 one\nxyz\n3 three\n") << "a refused file is left as it is";
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
