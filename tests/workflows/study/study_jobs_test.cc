// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/study_jobs.h"

#include <gtest/gtest.h>

#include <atomic>
#include <numeric>
#include <set>
#include <stdexcept>

namespace gaitwright {
namespace {

std::vector<std::size_t> Numbers(std::size_t count) {
  std::vector<std::size_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), std::size_t{0});
  return numbers;
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
