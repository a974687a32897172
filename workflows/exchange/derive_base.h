// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "planning/plan/terrain.h"
#include "workflows/exchange/even_motion.h"

namespace gaitwright {

/// Works out where the base is from the joints, by feet that stand still on the ground.
///
/// The base begins over the origin of W as it stands, its lowest feet on the ground. From row to row it is where the
/// feet that stand are nearest to where they came down (least squares; a sphere rolls on), which with three feet says
/// everything; what it leaves open, as the turning about the line through two point feet, is taken as upright as the
/// standing posture, and as it was. A foot that comes down is drawn onto the ground within a tenth of a second. Without
/// any foot on the ground by the column of contacts the base flies on as it fell; without that column it never flies.
/// All of it is smoothed, by smoothing_hz or above 10 Hz.
///
/// Feet stand that the column of contacts says, or else those that are no higher over the ground than `contact_height`
/// says over the lowest of them; then, twice more, those that ScheduleOf finds.
/// @param turned  the motion has the base's rotation, which is kept; only its position is worked out.
void DeriveBase(const RobotModel& model, const Terrain& terrain, const ImportOptions& options, bool turned,
                EvenMotion& motion, std::vector<DerivedPart>& derived);

}  // namespace gaitwright
