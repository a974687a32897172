// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "kinematics/ik/leg_closed_form.h"

namespace gaitwright {

/// The leg of most four-legged robots: an abduction joint, then hip and knee about parallel axes, and a point or sphere
/// as foot. Abduction axis and pitch axes need not meet, only not be parallel; offsets along all axes are allowed.
///
///   1. The knee's plane: turning the target back about axis 1 must bring it to the foot's own offset along the pitch
///      axis. Two branches, the leg below or above its abduction axis.
///   2. The knee from the distance between hip and foot in that plane (law of cosines). Two branches.
///   3. The hip from the direction.
/// @return null when the leg is of another kind.
std::shared_ptr<const LegClosedForm> FitThreeJointForm(const LegChain& chain);

}  // namespace gaitwright
