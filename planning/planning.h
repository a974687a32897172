// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Gaits, grounds, footsteps and motion plans, and the audit that judges a plan.
// The headers included here, directly or indirectly, are installed. Everything else may change without notice.

#include "planning/audit/audit.h"
#include "planning/audit/audit_report.h"
#include "planning/footsteps/plan_footsteps.h"
#include "planning/footsteps/search_footsteps.h"
#include "planning/gait/find_gait.h"
#include "planning/gait/load_gaits.h"
#include "planning/paths/standing_feet.h"
#include "planning/plan/gait.h"
#include "planning/plan/motion_plan.h"
#include "planning/plan/plan_json.h"
#include "planning/plan/sample_plan.h"
#include "planning/plan/terrain.h"
#include "planning/plan/terrain_scale.h"
#include "planning/tasks/repertoire.h"
#include "planning/tasks/task_plan.h"
#include "planning/terrain/load_terrain.h"
