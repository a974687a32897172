// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "kinematics/model/robot_model.h"
#include "workflows/render/svg_to_png.h"

namespace gaitwright {

/// The robot in its standing posture, to scale: from the side, from the front, from a corner, and its feet from above.
/// In each view: the soles and points that planner, audit and playback use (ContactPoints), the axis of each joint as
/// an arrow with its number, the centre of mass and its projection onto the ground. A table has the names of the
/// joints.
/// @param mesh_folder  of the description, to search for meshes of visual geometry; "" searches for none.
SvgDrawing RobotDrawing(const RobotModel& model, const std::string& mesh_folder);

}  // namespace gaitwright
