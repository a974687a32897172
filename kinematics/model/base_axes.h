// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// Axes of a URDF's root link that point forward and up.
struct BaseAxes {
  Vector3 forward = Vector3::UnitX(), up = Vector3::UnitZ();

  bool are_usual() const { return forward == Vector3::UnitX() && up == Vector3::UnitZ(); }
};

/// "x", "-x", "y" and so on, in the order of AxisNamed's indices.
const std::vector<std::string>& AxisNames();
/// The unit vector of one of AxisNames.
Vector3 AxisNamed(int index);
std::string NameOfAxis(const Vector3& axis);

/// Derives the axes from the tree at joint positions zero: a robot whose limbs mirror each other about y = 0 has x
/// forward and z up, as usual. If its limbs mirror each other only along another axis, or also along x and bend about
/// x, or bend only about x, that axis is lateral; limbs hang down, and feet are longer in front than behind. Limbs that
/// bend about y more than about x step along x even if their sides are not alike. Names are not used; a robot with x up
/// and y lateral is not recognised. Needs bodies, joints and collision shapes.
BaseAxes DeriveBaseAxes(const RobotModel& model);

/// Rotates everything on the base, so that the base frame has x forward and z up.
void TurnBase(const BaseAxes& axes, RobotModel& model);

}  // namespace gaitwright
