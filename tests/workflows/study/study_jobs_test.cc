// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/study_jobs.h"

#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <set>
#include <sstream>
#include <stdexcept>

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

std::vector<std::size_t> Numbers(std::size_t count) {
  std::vector<std::size_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), std::size_t{0});
  return numbers;
}

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

TEST(Jobs, EachIsDoneOnceOnAnyNumberOfThreads) {
  for (const int threads : {0, 1, 2, 8}) {
    std::vector<std::atomic<int>> done(50);
    std::size_t last = 0;
    const JobOptions options{threads, [&](std::size_t so_far, std::size_t of) {
                               EXPECT_EQ(so_far, last + 1) << "told of one at a time";
                               EXPECT_EQ(of, 50U);
                               last = so_far;
                             }};
    EXPECT_TRUE(RunJobs(
        Numbers(50), [&](std::size_t job) { ++done[job]; }, options));
    for (const auto& times : done) EXPECT_EQ(times, 1);
    EXPECT_EQ(last, 50U);
  }
}

TEST(Jobs, StoppingBeginsNoMore) {
  std::atomic<int> done = 0;
  const JobOptions options{2, {}, [&] { return done >= 5; }};
  EXPECT_FALSE(RunJobs(
      Numbers(1000), [&](std::size_t) { ++done; }, options));
  EXPECT_LE(done, 7);
}

TEST(Jobs, WhatAJobThrowsComesOutWhenTheOthersHaveEnded) {
  std::atomic<int> running = 0;
  const auto job = [&](std::size_t number) {
    ++running;
    if (number == 3) {
      --running;
      throw std::runtime_error("job 3");
    }
    --running;
  };
  EXPECT_THROW(RunJobs(Numbers(100), job, {4}), std::runtime_error);
  EXPECT_EQ(running, 0);
}

}  // namespace
}  // namespace gaitwright
