// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "playback/score/stability_report.h"
#include "workflows/words/plan_tasks.h"

namespace gaitwright::examples {

/// Result of an instruction.
struct Obeyed {
  TaskPlan tasks;
  StabilityReport report;
};

/// From words to motion: converts an instruction in English or Chinese to a task plan, plans the motion, plays it in
/// physics and scores it.
/// @throws InvalidArgument that names the part that is not understood, or the reason why no plan exists.
Obeyed Obey(const std::string& instruction, const std::string& robot);

}  // namespace gaitwright::examples
