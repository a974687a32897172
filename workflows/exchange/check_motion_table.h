// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "planning/plan/terrain.h"
#include "workflows/exchange/motion_table.h"

namespace gaitwright {

/// Sees to it that a motion can be what its file says.
///
/// Refused: too few rows, more than an hour, a start beyond 1e10 s, quaternions whose length is not 1 to a hundredth,
/// values over 1e8; and what is likely in other units or in another order than it is taken to be, with the option that
/// says so: times in milli-, micro- or nanoseconds (rows half a second apart), angles in degrees (past the joints'
/// limits, and within them as degrees), lengths in millimetres, a quaternion with w first (CheckQuaternionOrder).
/// An option that is not at `detect` is believed without that.
/// @throws InvalidArgument in these cases; the hint is in its text.
void CheckMotionTable(const RobotModel& model, const Terrain& terrain, const ImportOptions& options,
                      const MotionTable& table);

/// The same for a motion that is compared and not played: its world may be its own, so that the height of the feet says
/// nothing of the order of its quaternions.
void CheckComparedTable(const RobotModel& model, const ImportOptions& options, const MotionTable& table);

/// Does something with a table. What it throws as InvalidArgument has joints before it that are past their limits in
/// most rows: signs, zeros and units that differ show in much else.
void BlameJoints(const RobotModel& model, const MotionTable& table, const std::function<void()>& work);

}  // namespace gaitwright
