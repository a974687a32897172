// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "workflows/cluster/shared_work.h"
#include "workflows/study/run_sweep.h"

namespace gaitwright {

/// RunSweep on all ranks of a run; call it on rank 0. The outcomes equal those of one process. With several ranks and
/// no given number of threads, one thread works on this rank.
/// @param identity  see StudyIdentity; it must be the same on all ranks.
/// @return failures as of RunSweep and SharedWork::Runners.
Result<std::vector<PointOutcome>> RunSharedSweep(SharedWork& work, const Study& study, const std::string& identity,
                                                 JobJournal& journal, const JobOptions& options);

/// Runs on the other ranks: computes points, one at a time, until rank 0 has all.
void ServeSweep(SharedWork& work, const Study& study, const std::string& identity);

}  // namespace gaitwright
