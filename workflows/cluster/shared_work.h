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

/// A work that the ranks of a run do together: rank 0 hands out its pieces, the others do them. Each rank makes one
/// before it can fail, and so whichever rank ends early, with a result or without, no other waits for it.
class SharedWork {
 public:
  explicit SharedWork(const Ranks& ranks) : ranks_(ranks) {}
  /// Lets the other ranks go; tells rank 0 that this one did not take part.
  ~SharedWork();
  SharedWork(const SharedWork&) = delete;
  SharedWork& operator=(const SharedWork&) = delete;

  const Ranks& ranks() const { return ranks_; }

  /// For rank 0, once: waits until all other ranks are ready, and gives a runner for each, which hands its pieces to
  /// that rank and waits for the outcomes. A runner is for one thread at a time, and throws InvalidArgument with the
  /// rank's own words where a piece failed there. None is to be used any more when this is destroyed.
  /// @return the runners, none when alone; a failure that names the rank that cannot take part, or whose work is
  /// another one.
  Result<std::vector<PieceRunner>> Runners(const RankReadiness& own);

  /// For the other ranks, once: says that it is ready, or why not, and runs pieces until rank 0 lets it go.
  /// @return whether it was let go after work, not for a problem of some rank; false at once where it served before.
  bool Serve(const RankReadiness& own, const PieceRunner& run);

 private:
  void LetGo(char kind);

  Ranks ranks_;
  bool begun_ = false, ended_ = false;
};

}  // namespace gaitwright
