// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "workflows/study/sweep.h"

namespace gaitwright {

/// A sweep that nobody ran: over speeds and cycle times, where slow points pass, faster ones fail in each way there is.
struct MadeUpSweep {
  Study study;
  std::vector<PointOutcome> outcomes;
};

/// @param over  axes as of the flag; those beyond the first change nothing. @param trials  of each point that stands.
MadeUpSweep MakeUpSweep(const std::vector<std::string>& over, int trials = 0, int samples = 0);

/// How often a text holds another.
int CountOf(const std::string& text, const std::string& part);

}  // namespace gaitwright
