// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "workflows/study/job_journal.h"
#include "workflows/study/run_point.h"
#include "workflows/study/study_jobs.h"

namespace gaitwright {

/// Hash of everything that determines a study's outcomes: version, robot, command, options, axes, points, metrics,
/// contents of the gait, sequence and ground files, and `trials`, a text that identifies the trials.
std::string StudyIdentity(const Study& study, const std::string& trials);

/// Computes a point in another process and waits for it. @return the outcome as written by PointToLine. May throw.
using PointRunner = std::function<std::string(std::size_t point)>;

/// Runs every point that the journal does not contain and returns all outcomes in order of their numbers: the same for
/// any number of threads, and for interrupted and resumed runs. Failure kBadInput for a damaged journal, and
/// `interrupted` if it was stopped.
/// @param elsewhere  see PointRunner; each has its own thread in addition to those of the options
Result<std::vector<PointOutcome>> RunSweep(const Study& study, JobJournal& journal, const JobOptions& options,
                                           const std::vector<PointRunner>& elsewhere = {});

}  // namespace gaitwright
