// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "kinematics/ik/leg_closed_form.h"

namespace gaitwright {

/// Closed form for the leg of most four-legged robots: an abduction joint, then hip and knee with parallel axes, and a
/// point or sphere as foot. Abduction axis and pitch axes must not be parallel, but need not meet. Offsets along all
/// axes are allowed.
///
///   1. The plane of the knee: the inverse rotation about axis 1 must bring the target to the offset of the foot along
///      the pitch axis. Two branches, with the leg below or above its abduction axis.
///   2. The knee from the distance between hip and foot in that plane (law of cosines). Two branches.
///   3. The hip from the direction.
/// @return null if the leg has another geometry.
std::shared_ptr<const LegClosedForm> FitThreeJointForm(const LegChain& chain);

}  // namespace gaitwright
