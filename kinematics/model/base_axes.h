// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// Which axes of its root link a URDF has ahead of the robot and up.
struct BaseAxes {
  Vector3 ahead = Vector3::UnitX(), up = Vector3::UnitZ();

  bool are_usual() const { return ahead == Vector3::UnitX() && up == Vector3::UnitZ(); }
};

/// "x", "-x", "y" and so on, in the order of AxisNamed's indices.
const std::vector<std::string>& AxisNames();
/// The unit vector of one of AxisNames.
Vector3 AxisNamed(int index);
std::string NameOfAxis(const Vector3& axis);

/// What the tree at joint positions zero tells: a robot whose limbs mirror each other from y to minus y has x ahead and
/// z up, as the conventions want it. One whose limbs do so along another axis alone, or along x too and bend about x,
/// or bend about x alone, has that axis across, its limbs hang down, and its feet are longer ahead than behind. Names
/// play no part; a robot with x up and y across is not seen as such. Needs bodies, joints and collision shapes.
BaseAxes DeriveBaseAxes(const RobotModel& model);

/// The same robot with a base frame that has x ahead and z up: everything on the base is turned.
void TurnBase(const BaseAxes& axes, RobotModel& model);

}  // namespace gaitwright
