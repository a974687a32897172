// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "workflows/cluster/ranks.h"

namespace gaitwright {

/// Does one piece of a work that is cut into numbered pieces, and gives its outcome as a text. May throw.
using PieceRunner = std::function<std::string(int)>;

/// What each rank says of itself before the work begins.
struct RankReadiness {
  std::string work;     ///< a hash of all that the work depends on; it must be the same on all ranks
  std::string problem;  ///< why this rank cannot take part; empty when it can
};

/// For rank 0: waits until all other ranks are ready, and gives a runner for each, which hands its pieces to that rank
/// and waits for the outcomes. A runner is for one thread at a time, and throws InvalidArgument with the rank's own
/// words where a piece failed there.
/// @return the runners, none when alone; a failure that names the rank that cannot take part, or whose work is another
/// one. The other ranks are let go then.
Result<std::vector<PieceRunner>> RunnersOnOtherRanks(const Ranks& ranks, const RankReadiness& own);

/// For rank 0, once no runner is used any more: lets the other ranks go.
void DismissOtherRanks(const Ranks& ranks);

/// For the other ranks: says that it is ready, or why not, and runs pieces until rank 0 lets it go.
/// @return whether it was let go after work, not for a problem of some rank.
bool ServeRankZero(const Ranks& ranks, const RankReadiness& own, const PieceRunner& run);

}  // namespace gaitwright
