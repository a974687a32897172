// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "planning/plan/terrain.h"
#include "workflows/exchange/motion_table.h"

namespace gaitwright {

/// Checks that the values of a motion file are plausible.
///
/// It refuses too few rows, more than an hour, a start beyond 1e10 s, quaternions whose length differs from 1 by more
/// than 0.01, and values over 1e8. It also refuses data that are probably in other units or another order than assumed,
/// and names the option that sets them: times in milli-, micro- or nanoseconds (rows half a second apart), angles in
/// degrees (beyond the joints' limits, but within them as degrees), lengths in millimetres, a quaternion with w first
/// (CheckQuaternionOrder). An option other than `detect` is used without this check.
/// @throws InvalidArgument in these cases; the hint is in its text.
void CheckMotionTable(const RobotModel& model, const Terrain& terrain, const ImportOptions& options,
                      const MotionTable& table);

/// As above for a motion that is only compared: its world frame may differ, so the height of the feet does not show the
/// order of its quaternions.
void CheckComparedTable(const RobotModel& model, const ImportOptions& options, const MotionTable& table);

/// Runs a function on a table. If it throws InvalidArgument, names the joints beyond their limits in most rows before
/// its message, because wrong signs, zero offsets and units cause many other errors.
void BlameJoints(const RobotModel& model, const MotionTable& table, const std::function<void()>& work);

}  // namespace gaitwright
