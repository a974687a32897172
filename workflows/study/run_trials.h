// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include "workflows/study/trial_book.h"

namespace gaitwright {

/// Does one trial by its number somewhere else, and waits for it. For one thread at a time; may throw.
using TrialRunner = std::function<Result<TrialOutcome>(int number)>;

/// Plays a plan many times under disturbances and puts together what came of it. The report depends on the study and
/// the options alone, `threads` apart: not on threads, nor on interruptions, nor on how often a run was resumed.
///
///     const Result<RobustnessReport> report = RunTrials({model, plan, request, disturbances}, {.trials = 100});
///
/// @return a failure when a trial cannot be played (of those, of the one with the lowest number), when the journal is
/// refused, or, with code `interrupted`, when `hooks.stop` ended it.
/// @throws InvalidArgument for options out of range, and as PlayTrial does.
Result<RobustnessReport> RunTrials(const TrialStudy& study, const TrialOptions& options, const TrialHooks& hooks = {});

/// The same with a book that the caller opened, on this process's threads and on all of `elsewhere`; the caller closes
/// the book once the report is safe. RunTrials closes its own at once.
Result<RobustnessReport> RunTrials(const TrialStudy& study, const TrialOptions& options, TrialBook& book,
                                   const std::vector<TrialRunner>& elsewhere = {});

}  // namespace gaitwright
