// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "workflows/walk/walk.h"
#include "workflows/words/plan_tasks.h"

namespace gaitwright {

/// Results of an instruction.
struct Done {
  PlannedTasks planned;
  PlayedWalk played;
};

Result<PlannedTasks> PlannedInWords(const RobotModel& model, const std::string& text, const Terrain& terrain);

/// Plans, audits, plays and scores; all must pass.
Done DoneInWords(const RobotModel& model, const std::string& text, const Terrain& terrain);

/// Distance of the measured ZMP from the planned one at the end [m].
double ZmpErrorAtEnd(const Done& done);

}  // namespace gaitwright
