// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/pybind11.h>

#include "kinematics/model/robot_model.h"
#include "planning/plan/terrain.h"

namespace gaitwright::python {

/// A ground made in Python, or one by its name or file, at the size of the robot.
/// @throws FailureError where there is none of that name, type_error for anything else.
Terrain TerrainOf(const pybind11::object& terrain, const RobotModel& model);

}  // namespace gaitwright::python
