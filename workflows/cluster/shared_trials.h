// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "workflows/cluster/shared_work.h"
#include "workflows/study/run_trials.h"

namespace gaitwright {

/// RunTrials on all ranks of a run; to be called on rank 0. The report is the same as that of one process. Where there
/// are several ranks and no number of threads is given, one thread plays on this rank.
/// @return failures as RunTrials and SharedWork::Runners.
Result<RobustnessReport> RunSharedTrials(SharedWork& work, const TrialStudy& study, const TrialOptions& options,
                                         TrialBook& book);

/// What came of a trial as a rank tells it: its outcome, or all of the failure.
std::string AnswerOf(const Result<TrialOutcome>& trial);

/// The same again. @throws InvalidArgument for a text that is neither.
Result<TrialOutcome> TrialOfAnswer(const std::string& answer);

/// What the other ranks do meanwhile: trials, one at a time, until rank 0 has enough.
void ServeTrials(SharedWork& work, const TrialStudy& study, const TrialOptions& options);

}  // namespace gaitwright
