// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "workflows/exchange/motion_table.h"

namespace gaitwright {

/// Names of the independent joints in the order in which the robot's description lists them. Retargeted data sets have
/// their columns in this order.
std::vector<std::string> DescribedJointOrder(const RobotModel& model);

/// Reads frames without names, as retargeted data sets have them: a table of numbers without a header, one frame a row:
///   base x y z [m], quaternion x y z w, then all joints in DescribedJointOrder [rad].
/// There may be one column of times [s] before these; otherwise frames are `rate_hz` apart. Failure kBadInput `csv` or
/// `columns` for another number of columns, with the accepted ones.
Result<MotionTable> ParseNumberFrames(const RobotModel& model, const std::string& text, const std::string& source,
                                      const ImportOptions& options);

/// Whether a JSON text has the frames of motion_imitation.
bool HoldsJsonFrames(const std::string& text);

/// Reads frames of motion_imitation, `{"LoopMode", "FrameDuration", "Frames": [[...], ...]}`, each as a row of
/// ParseNumberFrames. Failure kBadInput `import`, with the path to the value.
Result<MotionTable> ParseJsonFrames(const RobotModel& model, const std::string& text, const std::string& source,
                                    const ImportOptions& options);

/// Smoothing for positions without velocities in rows that are far apart: their second derivatives would be noise.
/// @return a cut-off frequency of a fifth of the rate [Hz]; 0 for rows at most 10 ms apart.
double CoarseSmoothingHz(const MotionTable& table);

}  // namespace gaitwright
