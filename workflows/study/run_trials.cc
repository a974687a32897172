// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/run_trials.h"

#include <algorithm>
#include <exception>
#include <mutex>
#include <thread>

namespace gaitwright {
namespace {

/// The work of one thread: plays trials until none are left.
class TrialCrew {
 public:
  explicit TrialCrew(TrialBook& book) : book_(book) {}

  void Work(const TrialRunner& run) {
    for (;;) {
      std::optional<int> number;
      {
        const std::lock_guard lock(mutex_);
        if (thrown_) return;
        number = book_.Next();
      }
      if (!number) return;
      try {
        Result<TrialOutcome> outcome = run(*number);
        const std::lock_guard lock(mutex_);
        outcome ? book_.Add(std::move(*outcome)) : book_.Fail(*number, outcome.failure());
      } catch (...) {
        const std::lock_guard lock(mutex_);
        if (!thrown_ || *number < thrown_by_) thrown_ = std::current_exception();
        thrown_by_ = thrown_by_ < 0 ? *number : std::min(thrown_by_, *number);
        return;
      }
    }
  }

  void Rethrow() const {
    if (thrown_) std::rethrow_exception(thrown_);
  }

 private:
  TrialBook& book_;
  std::mutex mutex_;
  std::exception_ptr thrown_;
  int thrown_by_ = -1;
};

}  // namespace

Result<RobustnessReport> RunTrials(const TrialStudy& study, const TrialOptions& options, TrialBook& book,
                                   const std::vector<TrialRunner>& elsewhere) {
  const int cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  const int threads = std::min(options.threads > 0 ? options.threads : cores, options.trials);
  const TrialRunner here = [&](int number) -> Result<TrialOutcome> {
    Result<PlayedTrial> trial = PlayTrial(study, number, book.SeedOf(number));
    if (!trial) return trial.failure();
    return std::move(trial->outcome);
  };
  TrialCrew crew(book);
  std::vector<std::thread> others;
  for (int i = 1; i < threads; ++i) others.emplace_back([&] { crew.Work(here); });
  for (const TrialRunner& run : elsewhere) others.emplace_back([&] { crew.Work(run); });
  crew.Work(here);
  for (std::thread& other : others) other.join();
  crew.Rethrow();
  return book.Report();
}

Result<RobustnessReport> RunTrials(const TrialStudy& study, const TrialOptions& options, const TrialHooks& hooks) {
  Result<TrialBook> book = TrialBook::Open(study, options, hooks);
  if (!book) return book.failure();
  Result<RobustnessReport> report = RunTrials(study, options, *book);
  if (report) book->Close();
  return report;
}

}  // namespace gaitwright
