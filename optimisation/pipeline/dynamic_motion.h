// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "optimisation/centroidal/centre_of_mass.h"
#include "planning/plan/gait.h"

namespace gaitwright {

/// Whether a motion is planned as that of a rigid body: because it is requested, or because the pendulum model is not
/// sufficient (at some time all stance feet change at once).
bool IsDynamic(const ContactSchedule& schedule, const CentreOfMassOptions& options);

/// The same decision for the steady cycle of a gait.
bool IsDynamic(const Gait& gait, const CentreOfMassOptions& options);

}  // namespace gaitwright
