// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/types.h>

#include "kinematics/base/result.h"
#include "workflows/sandbox/child_process.h"

namespace gaitwright {

/// Starts the process of a setup, with `reads` as its file 3 and `writes` as its file 4. Failure `child`, which names
/// the failed step and the system's reason.
Result<pid_t> StartChild(const ChildSetup& setup, int reads, int writes);

}  // namespace gaitwright
