// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The workflows, which join planning and playback: walks, trials, imported and exported motions, instructions.
// The headers that this header includes, directly or indirectly, are installed. All others are internal and may change
// without notice.

#include "workflows/exchange/export_motion.h"
#include "workflows/exchange/import_motion.h"
#include "workflows/exchange/placed_steps.h"
#include "workflows/grade/answer_table.h"
#include "workflows/study/run_trials.h"
#include "workflows/walk/plan_recovery.h"
#include "workflows/walk/walk.h"
#include "workflows/walk/walk_extent.h"
#include "workflows/words/interpret.h"
#include "workflows/words/plan_tasks.h"
