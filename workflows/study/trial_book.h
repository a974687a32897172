// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "kinematics/base/options.h"
#include "workflows/study/job_journal.h"
#include "workflows/study/trial.h"

namespace gaitwright {

/// Number of trials and seed of the run. The number of threads does not change the result.
struct TrialOptions {
  int trials = 500;
  double until_width = 0.0;
  int until_least = 50;
  int seed = 0;
  int threads = 0;

  OptionFields Fields() {
    return {
        {"trials", &trials, "1", 1, 10000000, "Maximum number of trials."},
        {"until_width", &until_width, "1", 0.0, 1.0,
         "Width of the 95 % interval of the survival rate at which the trials stop early; 0 disables this."},
        {"until_least", &until_least, "1", 1, 10000000, "Smallest number of trials before they may stop early."},
        {"seed", &seed, "1", 0, 2147483647, "Random seed of the run; each trial's seed is derived from it."},
        {"threads", &threads, "1", 0, 4096,
         "Number of threads; 0 uses one per core. The result does not depend on it."},
    };
  }
};

/// Progress of a run.
struct TrialProgress {
  int done = 0, restored = 0;  ///< finished trials, and how many of them come from an earlier part of the run
  int wanted = 0;              ///< number of all trials, minus those saved by stopping early
  int survived = 0;
};

/// Callbacks and journal of a run.
struct TrialHooks {
  std::string journal;                                      ///< file of the outcomes so far, or ""
  bool resume = false;                                      ///< continue with this file
  std::function<void(const TrialProgress&)> progress = {};  ///< after each trial, by one thread at a time
  std::function<bool()> stop = {};  ///< whether to hand out no more trials; called before each trial, by any thread
};

/// Bookkeeping of trials: hands out numbers, accepts outcomes in any order, stores them in the journal, and builds the
/// report from the outcomes up to the run's end, in order. Threads and processes that play the trials share one book;
/// it does not lock.
///
/// A run ends at its last trial or, with `until_width`, at the first number n >= until_least at which the interval of
/// trials 0 to n - 1 is narrow enough. Trials beyond the end are not in the report, so the speed of threads does not
/// matter. Trials of an earlier part beyond the end stay in the journal.
class TrialBook {
 public:
  /// @return a failure as of ReasonNotTried (before a journal is created), as of JobJournal::Open, or for a damaged
  /// outcome in the journal. @throws InvalidArgument for an option out of range.
  static Result<TrialBook> Open(const TrialStudy& study, const TrialOptions& options, const TrialHooks& hooks);

  /// The next trial that is not handed out yet; nothing if all are.
  std::optional<int> Next();
  /// The seed of a trial.
  std::uint64_t SeedOf(int number) const { return SeedOfTrial(static_cast<std::uint64_t>(options_.seed), number); }
  /// Accepts the outcome of a trial. @throws CannotKeep if the journal cannot be written.
  void Add(TrialOutcome outcome);
  /// Accepts a trial that could not be played: no more are handed out, and the run fails with the failure of the lowest
  /// trial number.
  void Fail(int number, const Failure& failure);

  bool complete() const { return prefix_ >= end_; }
  TrialProgress progress() const;

  /// The report; a failure if a trial failed, or, with code `interrupted`, if the run is not complete. The journal
  /// stays until Close.
  Result<RobustnessReport> Report();
  /// Trials of an earlier part of the run that are beyond the run's present end.
  int beyond() const { return static_cast<int>(journal_.found(static_cast<std::size_t>(end_))); }
  /// Deletes the journal after the report is saved. A journal with trials beyond the end is kept, because no report has
  /// them.
  void Close() {
    if (beyond() == 0) journal_.Remove();
  }

 private:
  TrialBook(const TrialStudy& study, const TrialOptions& options, TrialHooks hooks, JobJournal journal);
  std::optional<Failure> Restore();
  void Advance();
  void Count(int number, const TrialOutcome& outcome);
  void EndAt(int end);

  TrialSubject subject_;
  TrialOptions options_;
  TrialHooks hooks_;
  JobJournal journal_;
  std::map<int, TrialOutcome> outcomes_;
  std::map<int, Failure> failures_;
  int next_ = 0, end_ = 0, restored_ = 0;
  int done_ = 0, survived_ = 0;           ///< outcomes below end_
  int prefix_ = 0, prefix_survived_ = 0;  ///< outcomes without a gap from 0 on
};

}  // namespace gaitwright
