// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "workflows/study/sweep.h"

namespace gaitwright {

/// A synthetic sweep over speeds and cycle times: slow points pass, and faster points fail with every status.
struct MadeUpSweep {
  Study study;
  std::vector<PointOutcome> outcomes;
};

/// @param over  axes as for the flag; axes beyond the first have no effect. @param trials number of trials of each
///              point that does not fall.
MadeUpSweep MakeUpSweep(const std::vector<std::string>& over, int trials = 0, int samples = 0);

/// Number of occurrences of a text in another.
int CountOf(const std::string& text, const std::string& part);

}  // namespace gaitwright
