// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "workflows/exchange/even_motion.h"

namespace gaitwright {

/// A part of a motion that takes `factor` times as long as in the file.
struct SlowedPart {
  double start_s = 0.0, end_s = 0.0;  ///< of the file's motion
  double factor = 1.0;
  std::string why;  ///< half a sentence
};

/// A motion along slower times.
struct SlowedMotion {
  EvenMotion motion;            ///< positions
  std::vector<FootSet> stance;  ///< by row
  std::vector<double> file_s;   ///< by row: time of the file's motion
};

/// Slows parts of a motion. Between a part and the motion beside it the pace changes smoothly over 0.4 s.
SlowedMotion WithSlowParts(const EvenMotion& motion, const std::vector<FootSet>& stance,
                           const std::vector<SlowedPart>& parts);

/// Slows the surroundings of times of the file's motion further: each part in at most three steps up to `most`.
/// @param bad_s  in any order. @return false if nothing there can be slowed further.
bool SlowDown(std::vector<double> bad_s, double most, const std::string& why, std::vector<SlowedPart>& parts);

}  // namespace gaitwright
