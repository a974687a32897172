// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cli/command_line.h"
#include "kinematics/base/result.h"

namespace gaitwright::cli {

/// Says what is wrong with a command line, in one sentence that names the nearest verb or flag.
Failure UsageFailure(Verb program, const UsageError& error);

}  // namespace gaitwright::cli
