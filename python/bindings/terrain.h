// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/pybind11.h>

#include "kinematics/model/robot_model.h"
#include "planning/plan/terrain.h"

namespace gaitwright::python {

/// A ground made in Python, or a ground by name or file with default sizes for the robot.
/// @throws FailureError for an unknown name, type_error for a value of another type.
Terrain TerrainOf(const pybind11::object& terrain, const RobotModel& model);

}  // namespace gaitwright::python
