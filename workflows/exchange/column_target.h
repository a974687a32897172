// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "kinematics/model/robot_model.h"
#include "workflows/exchange/motion_table.h"

namespace gaitwright {

/// Meaning of a column.
enum class ColumnKind {
  kTime,
  kBasePosition,
  kQuaternion,  ///< index: x y z w
  kEuler,       ///< index: roll, pitch, yaw
  kBaseRate,    ///< index: v_WB, w_WB by axis
  kBaseAcceleration,
  kPosition,  ///< index: joint
  kVelocity,
  kAcceleration,
  kTorque,
  kContact,  ///< index: foot
  kForce,    ///< index: 3 foot + axis
};

/// A column with the factor that converts it to SI units.
struct ColumnTarget {
  ColumnKind kind = ColumnKind::kTime;
  int index = 0;
  double scale = 1.0;
};

/// All column names, with their meanings.
std::map<std::string, ColumnTarget> ColumnTargets(const RobotModel& model, const ImportOptions& options);

/// The name of the position column of a joint: "q_hip_rad" or "q_slide_m".
std::string PositionColumn(const Joint& joint);

/// Whether a name begins like a column name of this program, so that it was probably meant as one.
bool LooksLikeOurs(const std::string& name);

}  // namespace gaitwright
