// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "playback/score/stability_report.h"
#include "workflows/words/plan_tasks.h"

namespace gaitwright::examples {

/// What came of an instruction.
struct Obeyed {
  TaskPlan tasks;
  StabilityReport report;
};

/// From words to motion: an instruction in English or Chinese becomes a task plan, that a motion plan, and that is
/// played in physics and judged. @throws InvalidArgument with the part that is not understood, or why it cannot be.
Obeyed Obey(const std::string& instruction, const std::string& robot);

}  // namespace gaitwright::examples
