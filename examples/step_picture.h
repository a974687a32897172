// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "examples/pd_tuning.h"

namespace gaitwright::examples {

/// SVG picture with one plot for each step response over time: simulated, and by the formula.
std::string StepPicture(const std::vector<JointStep>& steps, int columns);

}  // namespace gaitwright::examples
