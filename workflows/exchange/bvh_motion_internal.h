// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "kinematics/base/result.h"
#include "workflows/exchange/motion_table.h"

namespace gaitwright {

/// Reads a BVH file (Biovision hierarchy) of a skeleton that has the robot's own joints (PartnersOf). At rest, the
/// skeleton must have the posture of the robot at zero positions: then its unit (m, cm or mm) and its axes follow from
/// the places of its joints. Rotations become angles about the axes of the robot's joints (SplitRotation).
/// Failure kBadInput `import`, with the line, or with the joints that have no partner.
Result<MotionTable> ParseBvhMotion(const RobotModel& model, const std::string& text, const std::string& source,
                                   const ImportOptions& options);

}  // namespace gaitwright
