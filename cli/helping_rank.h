// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>

#include "kinematics/base/result.h"
#include "workflows/cluster/shared_work.h"

namespace gaitwright::cli {

/// What the ranks of an MPI run beside rank 0 do: they write and print nothing, and pass over what asks a run to end.
/// @param serve  reads what the work is and takes part in it; what keeps it from that, a failure or an exception, rank
/// 0
///               is told, which tells it.
/// @return the exit status
int HelpRank0(SharedWork& work, const std::function<std::optional<Failure>()>& serve);

}  // namespace gaitwright::cli
