// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "workflows/exchange/csv_table.h"
#include "workflows/exchange/motion_columns.h"

namespace gaitwright {

/// Whether a table is a motion of OCS2's quadrupeds, by its columns.
bool IsOcs2Motion(const CsvTable& table);

/// The names of OCS2's motion CSV (ocs2_anymal_commands/LoadMotions, ocs2_quadruped_interface/QuadrupedLogger):
///   time, contactflag_LF, ..., base_positionInWorld_x, ..., base_quaternion_w, ..., base_linearvelocityInBase_x, ...,
///   base_angularvelocityInBase_x, ..., jointAngle_LF_HAA, ..., jointVelocity_LF_HAA, ..., contactForcesInWorld_LF_x,
/// with the legs LF, RF, LH, RH and the joints HAA, HFE, KFE. The quaternion has w first. Velocities of the base are in
/// its own frame and are left out, since they follow from its pose. Joints with these names, such as LF_HAA, are mapped
/// by name. For another robot with four legs of three joints, LF is the leg whose foot stands in front on the left, and
/// HAA is its first joint; `derived` says so. Failure kBadInput `ocs2` for a robot without such legs.
Result<ColumnNames> Ocs2ColumnNames(const RobotModel& model, const CsvTable& table, std::vector<DerivedPart>& derived);

}  // namespace gaitwright
