// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// Whether the plan says when its feet touch the ground. A plan without a contact schedule is only a command, such as
/// that of a learned policy: its rows hold a posture and the commanded path of the base.
inline bool PlansContacts(const MotionPlan& plan) { return !plan.schedule.phases.empty(); }

}  // namespace gaitwright
