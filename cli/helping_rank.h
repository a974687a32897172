// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>

#include "kinematics/base/result.h"
#include "workflows/cluster/shared_work.h"

namespace gaitwright::cli {

/// Runs a rank of an MPI run other than rank 0. It writes and prints nothing and ignores the signals that end a run.
/// @param serve  reads the inputs and takes part in the work; its failure or exception is sent to rank 0, which prints
///               it.
/// @return the exit status
int HelpRank0(SharedWork& work, const std::function<std::optional<Failure>()>& serve);

}  // namespace gaitwright::cli
