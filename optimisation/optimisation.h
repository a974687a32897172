// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Motion plans: of walks that pass their audit, and of given footsteps; and the problems from which they are made.
// The headers included here, directly or indirectly, are installed. Everything else may change without notice.

#include "optimisation/centroidal/preview_control.h"
#include "optimisation/pipeline/plan_motion.h"
#include "optimisation/pipeline/plan_posture.h"
#include "optimisation/search/plan_walk.h"
#include "optimisation/search/search_trace.h"
