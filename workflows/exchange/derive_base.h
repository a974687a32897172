// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "planning/plan/terrain.h"
#include "workflows/exchange/even_motion.h"

namespace gaitwright {

/// Derives the base pose from the joint positions and the stance feet.
///
/// The base starts above the origin of W in its standing orientation, with its lowest feet on the ground. In each row,
/// the base pose brings the stance feet closest to their touch-down positions (least squares; a sphere rolls). Three
/// feet determine the pose. Remaining freedom, such as the rotation about the line through two point feet, is resolved
/// by staying as upright as in the standing posture and close to the previous row. A foot that touches down is moved
/// onto the ground within 0.1 s. If the contact column has no foot on the ground, the base moves ballistically; without
/// a contact column it never does. The result is smoothed with smoothing_hz, or 10 Hz.
///
/// Stance feet are those of the contact column. Without it, they are first the feet within `contact_height` of the
/// lowest one; then the base is derived twice more with the stance feet that ScheduleOf finds.
/// @param turned  the motion has the base's rotation, which is kept; only its position is derived.
void DeriveBase(const RobotModel& model, const Terrain& terrain, const ImportOptions& options, bool turned,
                EvenMotion& motion, std::vector<DerivedPart>& derived);

}  // namespace gaitwright
