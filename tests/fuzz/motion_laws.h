// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "kinematics/model/robot_model.h"
#include "tests/fuzz/reader.h"
#include "workflows/exchange/motion_table.h"

namespace gaitwright::fuzz {

/// Far beyond any motion, and small enough to avoid overflow of sums.
inline constexpr double kMostOfAnything = 1e9;

/// The robot of all motions.
const RobotModel& Quadruped();

/// Whether all values are finite and not too large.
bool IsSensible(const VectorX& values);

/// Checks the laws of a motion that was read, and of its plan if it is short. @param file  its file.
Verdict CheckMotion(const Result<MotionTable>& read, const std::string& file);

}  // namespace gaitwright::fuzz
