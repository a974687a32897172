// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include "workflows/study/trial_book.h"

namespace gaitwright {

/// Plays a trial in another process and waits for it. For one thread at a time; may throw.
using TrialRunner = std::function<Result<TrialOutcome>(int number)>;

/// Plays a plan many times under disturbances and collects the outcomes. The report depends only on the study and the
/// options, not on the number of threads, interruptions or resumed runs.
///
///     const Result<RobustnessReport> report = RunTrials({model, plan, request, disturbances}, {.trials = 100});
///
/// @return a failure if a trial cannot be played (the one with the lowest number), if the journal is refused, or, with
/// code `interrupted`, if `hooks.stop` ended the run.
/// @throws InvalidArgument for options out of range, and as PlayTrial does.
Result<RobustnessReport> RunTrials(const TrialStudy& study, const TrialOptions& options, const TrialHooks& hooks = {});

/// As above with a book that the caller opened, on the threads of this process and on all runners in `elsewhere`. The
/// caller closes the book after saving the report. The overload above closes its book at once.
Result<RobustnessReport> RunTrials(const TrialStudy& study, const TrialOptions& options, TrialBook& book,
                                   const std::vector<TrialRunner>& elsewhere = {});

}  // namespace gaitwright
