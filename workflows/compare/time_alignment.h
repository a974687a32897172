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

/// The names that both lists have, in the order of the first.
std::vector<NamedPair> CommonNames(const std::vector<std::string>& a, const std::vector<std::string>& b);

/// Offset between the clocks of two motions, and how well the motions agree at this offset.
struct ClockOffset {
  double offset_s = 0.0;   ///< time of B minus time of A at the same moment
  double agreement = 0.0;  ///< 1: equal joint speeds; 0: no correlation
};

/// The offset with the best agreement of the joint speeds:
///   agreement(s) = 2 sum a(t) b(t + s) / sum (a(t)^2 + b(t + s)^2)
/// over the shared joints and the times at which both have rows. This is a cross-correlation that also decreases if the
/// amplitudes differ. It tries all offsets whose overlap has half of the shorter motion and, on each side, a third of
/// the energy (sum of squared speeds) of the less energetic motion, so that a short piece is found in a whole motion.
/// The search uses Fourier transforms at steps of 5 ms, then refines the best offset to 0.1 ms. A computed speed counts
/// at most as the other side's largest speed of the joint, since a jump of a position is not motion. Nothing if no
/// shared joint moves in both motions.
std::optional<ClockOffset> BestOffset(const ComparedMotion& a, const ComparedMotion& b,
                                      const std::vector<NamedPair>& joints);

}  // namespace gaitwright
