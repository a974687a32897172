// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "workflows/study/job_journal.h"
#include "workflows/study/run_point.h"
#include "workflows/study/study_jobs.h"

namespace gaitwright {

/// Hash of all that shapes a study's outcomes: version, robot, command, options, axes, points, metrics, what stands in
/// the files of gaits, sequence and ground, and `trials`, a text that says what the trials are.
std::string StudyIdentity(const Study& study, const std::string& trials);

/// Does one point by its number somewhere else, and waits for it: the outcome as PointToLine writes it. May throw.
using PointRunner = std::function<std::string(std::size_t point)>;

/// Runs every point that the journal does not hold and gives all outcomes in the order of their numbers: the same for
/// any number of threads, and whether or not it was cut off and resumed. Failure kBadInput for a broken journal, and
/// `interrupted` when it was stopped.
/// @param elsewhere  see PointRunner; each has a thread of its own beside those of the options
Result<std::vector<PointOutcome>> RunSweep(const Study& study, JobJournal& journal, const JobOptions& options,
                                           const std::vector<PointRunner>& elsewhere = {});

}  // namespace gaitwright
