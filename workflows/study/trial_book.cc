// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/trial_book.h"

#include <fmt/format.h>

namespace gaitwright {
namespace {

Result<JobJournal> JournalOf(const TrialStudy& study, const TrialOptions& options, const TrialHooks& hooks) {
  if (hooks.journal.empty()) return JobJournal();
  return JobJournal::Open(hooks.journal, HashOf(study, static_cast<std::uint64_t>(options.seed)), hooks.resume);
}

}  // namespace

TrialBook::TrialBook(const TrialStudy& study, const TrialOptions& options, TrialHooks hooks, JobJournal journal)
    : subject_(SubjectOf(study, static_cast<std::uint64_t>(options.seed))),
      options_(options),
      hooks_(std::move(hooks)),
      journal_(std::move(journal)),
      end_(options.trials) {}

Result<TrialBook> TrialBook::Open(const TrialStudy& study, const TrialOptions& options, const TrialHooks& hooks) {
  TrialOptions checked = options;
  CheckOptions(checked.Fields());
  if (auto failure = ReasonNotTried(study)) return *failure;
  Result<JobJournal> journal = JournalOf(study, options, hooks);
  if (!journal) return journal.failure();
  TrialBook book(study, options, hooks, std::move(*journal));
  if (auto failure = book.Restore()) return *failure;
  return book;
}

std::optional<Failure> TrialBook::Restore() {
  for (int number = 0; number < options_.trials; ++number) {
    const std::optional<std::string> line = journal_.Find(static_cast<std::size_t>(number));
    if (!line) continue;
    try {
      TrialOutcome outcome = OutcomeFromLine(*line);
      if (outcome.number != number) throw InvalidArgument(fmt::format("it belongs to trial {}", outcome.number));
      Count(number, outcomes_.emplace(number, std::move(outcome)).first->second);
    } catch (const InvalidArgument& error) {
      return Failure{FailureKind::kBadInput,
                     FailureCode::kJournalLine,
                     "RunTrials",
                     fmt::format("'{}' is damaged at trial {}: {}", hooks_.journal, number, error.what()),
                     {fmt::format("delete '{}' to start again", hooks_.journal)}};
    }
  }
  restored_ = static_cast<int>(outcomes_.size());
  Advance();
  return std::nullopt;
}

std::optional<int> TrialBook::Next() {
  if (!failures_.empty() || (hooks_.stop && hooks_.stop())) return std::nullopt;
  while (outcomes_.count(next_) > 0) ++next_;
  if (next_ >= end_) return std::nullopt;
  return next_++;
}

void TrialBook::Count(int number, const TrialOutcome& outcome) {
  if (number >= end_) return;
  ++done_;
  survived_ += outcome.survived ? 1 : 0;
}

void TrialBook::EndAt(int end) {
  end_ = end;
  done_ = survived_ = 0;
  for (const auto& [number, outcome] : outcomes_) Count(number, outcome);
}

void TrialBook::Advance() {
  for (auto at = outcomes_.find(prefix_); at != outcomes_.end() && at->first == prefix_ && prefix_ < end_; ++at) {
    ++prefix_;
    prefix_survived_ += at->second.survived ? 1 : 0;
    const bool narrow = options_.until_width > 0.0 && prefix_ >= options_.until_least &&
                        WilsonInterval(prefix_survived_, prefix_).width() < options_.until_width;
    if (narrow) EndAt(prefix_);
  }
}

void TrialBook::Add(TrialOutcome outcome) {
  const int number = outcome.number;
  journal_.Add(static_cast<std::size_t>(number), OutcomeToLine(outcome));
  const auto [added, is_new] = outcomes_.emplace(number, std::move(outcome));
  if (is_new) Count(number, added->second);
  Advance();
  if (hooks_.progress) hooks_.progress(progress());
}

void TrialBook::Fail(int number, const Failure& failure) { failures_.emplace(number, failure); }

TrialProgress TrialBook::progress() const {
  return {.done = done_, .restored = restored_, .wanted = end_, .survived = survived_};
}

Result<RobustnessReport> TrialBook::Report() {
  if (!failures_.empty()) return failures_.begin()->second;
  if (!complete()) {
    const std::string kept =
        hooks_.journal.empty() ? "nothing is kept" : fmt::format("'{}' keeps them", hooks_.journal);
    return Failure{FailureKind::kBadInput,
                   FailureCode::kInterrupted,
                   "RunTrials",
                   fmt::format("interrupted after {} of {} trials; {}", progress().done, end_, kept),
                   {"run the same command with --resume to continue"}};
  }
  std::vector<TrialOutcome> outcomes;
  for (int i = 0; i < end_; ++i) outcomes.push_back(outcomes_.at(i));
  return ReduceTrials(subject_, std::move(outcomes));
}

}  // namespace gaitwright
