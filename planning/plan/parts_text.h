// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// Start of each part, such as "trot from 0.00 s, stand from 3.40 s, bound from 4.20 s"; empty for a single part.
std::string PartsText(const std::vector<MotionPart>& parts);

}  // namespace gaitwright
