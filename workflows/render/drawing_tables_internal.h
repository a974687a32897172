// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// Tables beside or below the views of a robot's drawing: a part of an SVG, and its height.
struct DrawnTable {
  std::string svg;
  double height_px = 0.0;
};

/// The signs of the drawing, the feet with their sizes, and the joints with number, name and axis, in as many columns
/// as fit. Needs ForwardKinematics.
DrawnTable DrawnTables(const RobotModel& model, const DynamicsScratch& scratch, const Vector2& at_px, double width_px);

}  // namespace gaitwright
