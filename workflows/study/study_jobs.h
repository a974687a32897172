// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "kinematics/base/result.h"

namespace gaitwright {

/// Options for running jobs.
struct JobOptions {
  int threads = 1;                                                      ///< 0: one per core
  std::function<void(std::size_t done, std::size_t of)> progress = {};  ///< called by one thread at a time
  std::function<bool()> stop = {};  ///< whether to start no more jobs; called before each job, by any thread
};

/// Runs the job with this number.
using JobRunner = std::function<void(std::size_t)>;

/// Runs `job` for every number in `order`, in this order, on the given number of threads, and waits for all. An
/// exception of a job is rethrown after the others have ended; with several exceptions, that of the earliest job in the
/// order.
/// @param elsewhere  the same job on other machines; each has its own additional thread, which waits for it
/// @return whether all jobs were done; false if `stop` ended the run.
bool RunJobs(const std::vector<std::size_t>& order, const JobRunner& job, const JobOptions& options,
             const std::vector<JobRunner>& elsewhere = {});

/// The failure `interrupted` of work that was stopped.
Failure Interrupted(const std::string& stage);

}  // namespace gaitwright
