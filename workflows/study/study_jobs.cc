// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/study_jobs.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>

namespace gaitwright {

bool RunJobs(const std::vector<std::size_t>& order, const JobRunner& job, const JobOptions& options,
             const std::vector<JobRunner>& elsewhere) {
  std::atomic<std::size_t> next = 0;
  std::atomic<bool> failed = false;
  std::mutex mutex;
  std::size_t done = 0;
  std::vector<std::exception_ptr> thrown(order.size());
  const auto stopped = [&] { return options.stop && options.stop(); };
  const auto work = [&](const JobRunner& run) {
    for (std::size_t at = 0; !failed && !stopped() && (at = next++) < order.size();) {
      try {
        run(order[at]);
        const std::lock_guard lock(mutex);
        ++done;
        if (options.progress) options.progress(done, order.size());
      } catch (...) {
        thrown[at] = std::current_exception();
        failed = true;
      }
    }
  };
  const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
  const std::size_t wanted = options.threads > 0 ? static_cast<std::size_t>(options.threads) : cores;
  std::vector<std::jthread> threads;
  for (std::size_t i = 1; i < std::min(wanted, order.size()); ++i) threads.emplace_back([&] { work(job); });
  for (const JobRunner& run : elsewhere) threads.emplace_back([&] { work(run); });
  work(job);
  threads.clear();
  for (const std::exception_ptr& exception : thrown) {
    if (exception) std::rethrow_exception(exception);
  }
  return done == order.size();
}

Failure Interrupted(const std::string& stage) {
  return {FailureKind::kBadInput,
          FailureCode::kInterrupted,
          stage,
          "interrupted before the end; results so far are kept",
          {"run the same command line with --resume to continue"}};
}

}  // namespace gaitwright
