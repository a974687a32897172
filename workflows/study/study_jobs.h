// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "kinematics/base/result.h"

namespace gaitwright {

/// How jobs are run.
struct JobOptions {
  int threads = 1;                                                      ///< 0: one for each core
  std::function<void(std::size_t done, std::size_t of)> progress = {};  ///< called by one thread at a time
  std::function<bool()> stop = {};  ///< whether to begin no more jobs; asked before each, by any thread
};

/// Does the job of a number.
using JobRunner = std::function<void(std::size_t)>;

/// Runs `job` for every number in `order`, the first ones first, on so many threads, and waits for all. What a job
/// throws is thrown again when the others have ended, that of the earliest in the order first.
/// @param elsewhere  the same job done in other places: each has a thread of its own beside those, which waits for it
/// @return whether all were done; false when `stop` ended it.
bool RunJobs(const std::vector<std::size_t>& order, const JobRunner& job, const JobOptions& options,
             const std::vector<JobRunner>& elsewhere = {});

/// The failure `interrupted` of work that was stopped.
Failure Interrupted(const std::string& stage);

}  // namespace gaitwright
