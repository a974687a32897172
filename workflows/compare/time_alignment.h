// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "workflows/exchange/compared_motion.h"

namespace gaitwright {

/// A joint or a foot that two motions have, by its name.
struct NamedPair {
  std::string name;
  int a = 0, b = 0;  ///< its index on each side
};

/// What both have, in the order of the first.
std::vector<NamedPair> CommonNames(const std::vector<std::string>& a, const std::vector<std::string>& b);

/// How far the clock of one motion is ahead of another's, and how well the two then agree.
struct ClockOffset {
  double offset_s = 0.0;   ///< time of B minus time of A at the same moment
  double agreement = 0.0;  ///< 1 where the joints' speeds are the same, 0 where they have nothing in common
};

/// The offset at which the speeds of the joints agree best:
///   agreement(s) = 2 sum a(t) b(t + s) / sum (a(t)^2 + b(t + s)^2)
/// over the joints that both have and the times at which both have rows, that is a cross-correlation that a motion of
/// another size lowers too. All offsets are tried that leave half of the shorter motion and, on either side, a third of
/// what moves (sum of squared speeds) in the motion that moves less, so that a short piece of a motion is found in the
/// whole of it; at 5 ms by Fourier transforms, then about the best to 0.1 ms. Speeds that are worked out count at most
/// as large as the other side's largest of that joint: a position that jumps is no motion. Nothing where no joint that
/// both have moves in both.
std::optional<ClockOffset> BestOffset(const ComparedMotion& a, const ComparedMotion& b,
                                      const std::vector<NamedPair>& joints);

}  // namespace gaitwright
