// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "kinematics/base/result.h"
#include "workflows/exchange/motion_table.h"

namespace gaitwright {

/// Whether a JSON text has the frames of DeepMimic: `Frames` without `FrameDuration`.
bool HoldsDeepMimicFrames(const std::string& text);

/// Reads frames of DeepMimic, `{"Loop", "Frames": [[duration, x, y, z, quaternion w x y z, joints...], ...]}`, with the
/// joints in DescribedJointOrder: a hinge as an angle, and a ball joint as a quaternion with w first, in axes that are
/// those of the base at zero positions. Ball joints are the runs of StemRuns with three hinges, or with two or three;
/// the number of columns decides. The axis upward is y, or z: the one along which the base is as high as it stands.
/// Failure kBadInput `import`, with the path to the value.
Result<MotionTable> ParseDeepMimic(const RobotModel& model, const std::string& text, const std::string& source,
                                   const ImportOptions& options);

}  // namespace gaitwright
