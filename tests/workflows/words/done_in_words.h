// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "workflows/walk/walk.h"
#include "workflows/words/plan_tasks.h"

namespace gaitwright {

/// What an instruction led to.
struct Done {
  PlannedTasks planned;
  PlayedWalk played;
};

Result<PlannedTasks> PlannedInWords(const RobotModel& model, const std::string& text, const Terrain& terrain);

/// Plans, audits, plays and scores; all has to pass.
Done DoneInWords(const RobotModel& model, const std::string& text, const Terrain& terrain);

/// How far the measured ZMP is from the planned one at the end [m].
double ZmpErrorAtEnd(const Done& done);

}  // namespace gaitwright
