// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "examples/pd_tuning.h"

namespace gaitwright::examples {

/// Step responses over time, simulated on top of the formula's, a plot for each, as one SVG picture.
std::string StepPicture(const std::vector<JointStep>& steps, int columns);

}  // namespace gaitwright::examples
