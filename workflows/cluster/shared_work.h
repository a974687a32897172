// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "workflows/cluster/ranks.h"

namespace gaitwright {

/// Computes one numbered piece of a work and returns its outcome as text. May throw.
using PieceRunner = std::function<std::string(int)>;

/// Announcement of each rank before the work begins.
struct RankReadiness {
  std::string work;     ///< a hash of everything that affects the work; it must be the same on all ranks
  std::string problem;  ///< why this rank cannot take part; empty if it can
};

/// Work shared by the ranks of a run: rank 0 hands out pieces, the others compute them. Each rank creates one before it
/// can fail, so no rank waits for one that ended early.
class SharedWork {
 public:
  explicit SharedWork(const Ranks& ranks) : ranks_(ranks) {}
  /// On rank 0, releases the other ranks; on another rank, tells rank 0 that it did not take part.
  ~SharedWork();
  SharedWork(const SharedWork&) = delete;
  SharedWork& operator=(const SharedWork&) = delete;

  const Ranks& ranks() const { return ranks_; }

  /// For rank 0, once: waits until all other ranks are ready. Returns a runner for each rank, which sends pieces to the
  /// rank and waits for the outcomes. A runner is for one thread at a time, and throws InvalidArgument with the rank's
  /// message if a piece failed there. Runners must not outlive this object.
  /// @return the runners, none if there is no other rank; a failure that names the rank that cannot take part or whose
  /// work differs.
  Result<std::vector<PieceRunner>> Runners(const RankReadiness& own);

  /// For the other ranks, once: reports that it is ready, or why not, and runs pieces until rank 0 releases it.
  /// @return true if the rank was released after the work, false if it was released because of a rank's problem or has
  /// served before.
  bool Serve(const RankReadiness& own, const PieceRunner& run);

 private:
  void LetGo(char kind);

  Ranks ranks_;
  bool begun_ = false, ended_ = false;
};

}  // namespace gaitwright
