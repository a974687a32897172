// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Motion plans: of walks that pass their audit, of footsteps that are given, and the problems behind them.
// What this header reaches is installed; all else belongs to the library and may change without notice.

#include "optimisation/centroidal/preview_control.h"
#include "optimisation/pipeline/plan_motion.h"
#include "optimisation/pipeline/plan_posture.h"
#include "optimisation/search/plan_walk.h"
#include "optimisation/search/search_trace.h"
