// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "workflows/exchange/motion_rows.h"

namespace gaitwright {

/// Column names that MotionCsv writes for complete rows: time_s, base_x_m, base_y_m, base_z_m, base_qx, base_qy,
/// base_qz, base_qw, then by joint q_<joint>_rad, v_<joint>_rad_s and tau_<joint>_nm (for prismatic joints _m, _m_s and
/// _n), and by foot contact_<link>.
std::vector<std::string> MotionCsvColumns(const RobotModel& model);

/// The rows as CSV (docs/export.md): one header line, one line per row, separated by commas, with the shortest decimals
/// that read back exactly. Torques and contacts are left out if the rows have none.
/// @throws InvalidArgument that names the column and the time of a value that is not finite.
std::string MotionCsv(const RobotModel& model, const MotionRows& rows);

}  // namespace gaitwright
