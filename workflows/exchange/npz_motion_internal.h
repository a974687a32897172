// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "workflows/exchange/motion_table.h"

namespace gaitwright {

/// Names of the independent joints by their depth in the tree, and at one depth in the order of their parents and then
/// of the description: the order of simulators that build a robot breadth first.
std::vector<std::string> BreadthFirstJointOrder(const RobotModel& model);

/// Reads a motion from a `.npz` of NumPy with one of these sets of arrays, all with a row for each frame:
///   joint_pos, body_pos_w (frames x bodies x 3), body_quat_w (w x y z): the first body is the base;
///   dof_pos, root_pos, root_rot (x y z w);
///   time_s, q, joint_names, and v, a, tau, contact, contact_wrench: what MotionNpz writes.
/// `fps` gives the rate of the first two; without it, options.rate_hz does. `joint_names` gives the order of the
/// joints. Without it, the order is that of the description or BreadthFirstJointOrder: the one for which the bodies are
/// where the file says. Failure kBadInput `import` with the reason.
Result<MotionTable> ParseNpzMotion(const RobotModel& model, const std::string& bytes, const std::string& source,
                                   const ImportOptions& options);

}  // namespace gaitwright
