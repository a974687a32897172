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

/// How many trials, and of which run. How many threads do them changes nothing in the result.
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

/// How far a run is.
struct TrialProgress {
  int done = 0, restored = 0;  ///< trials that are finished, and how many of them an earlier part of the run did
  int wanted = 0;              ///< trials in all, less those that stopping early saves
  int survived = 0;
};

/// What goes on beside a run.
struct TrialHooks {
  std::string journal;                                      ///< file of the outcomes so far; "" for none
  bool resume = false;                                      ///< go on with that file
  std::function<void(const TrialProgress&)> progress = {};  ///< after each trial, by one thread at a time
  std::function<bool()> stop = {};  ///< whether to hand out no more trials; asked before each, by any thread
};

/// Who has to do which trial, and what came of it: hands out numbers, takes outcomes in any order, keeps them in the
/// journal, and puts the report together from those up to the run's end, in order. Threads and processes that do the
/// trials share one; it does not lock.
///
/// A run ends at its last trial or, with `until_width`, at the first number n >= until_least at which the outcomes of
/// the trials 0 to n - 1 have an interval that is narrow enough. What was done beyond that is not in the report, so
/// that who was quick does not matter. What an earlier part did beyond the end, since it had more to do, stays in the
/// journal.
class TrialBook {
 public:
  /// @return a failure as WhyNotTried, before a journal is there, as JobJournal::Open, or for an outcome there that is
  /// broken. @throws InvalidArgument for an option out of range.
  static Result<TrialBook> Open(const TrialStudy& study, const TrialOptions& options, const TrialHooks& hooks);

  /// The next trial that nobody has; nothing when all are handed out.
  std::optional<int> Next();
  /// Its seed.
  std::uint64_t SeedOf(int number) const { return SeedOfTrial(static_cast<std::uint64_t>(options_.seed), number); }
  /// Takes what came of a trial. @throws CannotKeep when the journal cannot be written.
  void Add(TrialOutcome outcome);
  /// Takes a trial that could not be played: then no more are handed out, and the run fails with the failure of the
  /// trial of the lowest number.
  void Fail(int number, const Failure& failure);

  bool complete() const { return prefix_ >= end_; }
  TrialProgress progress() const;

  /// The report; a failure when a trial failed, or when the run is not complete: code `interrupted`. The journal stays
  /// until Close.
  Result<RobustnessReport> Report();
  /// Trials that an earlier part of the run did, and that are beyond its end now.
  int beyond() const { return static_cast<int>(journal_.found(static_cast<std::size_t>(end_))); }
  /// Deletes the journal, once the report is safe; it stays where trials are beyond the end, which are in no report.
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
