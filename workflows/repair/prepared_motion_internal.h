// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "workflows/repair/follow_weights_internal.h"
#include "workflows/repair/repair_motion_internal.h"

namespace gaitwright {

/// Everything that is known of a motion before its whole body is optimised.
struct PreparedMotion {
  Terrain terrain;
  std::string source_hash;             ///< of the file, or of the numbers of the request
  EvenMotion of_file;                  ///< with the contacts found
  std::optional<MotionPlan> as_it_is;  ///< the file's motion, if it passes its audit
  MotionFindings findings;
  FollowWeights weights = {};
  std::string weights_hash = {};                    ///< of their file; "" without one
  std::shared_ptr<const EvenMotion> original = {};  ///< positions of the file's motion, with the times of `rested`
};

/// Reads a motion, finds its contacts and audits it. @throws InvalidArgument for a motion that is probably
/// misinterpreted.
Result<PreparedMotion> ReadAndFind(const RobotModel& model, RepairRequest request);

/// Leaves out and slows the parts of the findings, brings the motion to rest at its ends, and makes its contacts clean.
/// @throws InvalidArgument as of CleanContacts.
void Arrange(const RobotModel& model, const RepairOptions& options, PreparedMotion& prepared);

/// Positions, velocities and accelerations of smooth curves through rows. @param cutoff_hz  0: exactly through them.
EvenMotion SmoothRows(const RobotModel& model, const EvenMotion& rows, double cutoff_hz);

}  // namespace gaitwright
