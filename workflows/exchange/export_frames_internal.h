// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "workflows/exchange/motion_rows.h"

namespace gaitwright {

/// Rows as frames without names: base x y z [m], quaternion x y z w, then all joints in DescribedJointOrder. `import`
/// reads them back (ParseNumberFrames).
std::string FramesCsv(const RobotModel& model, const MotionRows& rows);

/// The same frames as motion_imitation's {"LoopMode", "FrameDuration", "Frames"}; six decimals.
/// @param wraps  the motion repeats itself from its last frame on: "Wrap" instead of "Clamp".
std::string FramesJson(const RobotModel& model, const MotionRows& rows, double rate_hz, bool wraps = false);

/// Rows as the arrays that frameworks for imitation learning read: fps, joint_pos, joint_vel (DescribedJointOrder),
/// body_pos_w, body_quat_w (w x y z), body_lin_vel_w and body_ang_vel_w (frames x bodies, the base first), joint_names,
/// body_names.
std::string FramesNpz(const RobotModel& model, const MotionRows& rows, double rate_hz);

/// What a reader of frames must know: the order of the joints, and the rate if the file does not contain it.
std::string FramesNote(const RobotModel& model, double rate_hz, bool without_rate);

}  // namespace gaitwright
