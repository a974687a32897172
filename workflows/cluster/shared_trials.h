// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "workflows/cluster/shared_work.h"
#include "workflows/study/run_trials.h"

namespace gaitwright {

/// RunTrials on all ranks of a run; call it on rank 0. The report equals that of one process. With several ranks and no
/// given number of threads, one thread plays on this rank.
/// @return failures as of RunTrials and SharedWork::Runners.
Result<RobustnessReport> RunSharedTrials(SharedWork& work, const TrialStudy& study, const TrialOptions& options,
                                         TrialBook& book);

/// Message of a rank about a trial: its outcome, or the whole failure.
std::string AnswerOf(const Result<TrialOutcome>& trial);

/// Reads such a message. @throws InvalidArgument for a text that is neither.
Result<TrialOutcome> TrialOfAnswer(const std::string& answer);

/// Runs on the other ranks: plays trials, one at a time, until rank 0 has enough.
void ServeTrials(SharedWork& work, const TrialStudy& study, const TrialOptions& options);

}  // namespace gaitwright
