// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "optimisation/centroidal/centre_of_mass.h"
#include "planning/plan/gait.h"

namespace gaitwright {

/// Whether a motion over a schedule is planned as that of a rigid body, since a pendulum on its feet cannot do it:
/// asked for, or with a time at which none of the feet that carry goes on to.
bool IsDynamic(const ContactSchedule& schedule, const CentreOfMassOptions& options);

/// The same of a gait's steady cycle.
bool IsDynamic(const Gait& gait, const CentreOfMassOptions& options);

}  // namespace gaitwright
