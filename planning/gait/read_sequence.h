// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// A requested part of a sequence: a gait by name with a command, or standing still for the command's duration.
struct AskedPart {
  std::string gait;  ///< a name as in FindGait; "stand" for standing still
  WalkCommand command;

  bool stands() const { return gait == "stand"; }
  bool operator==(const AskedPart&) const = default;
};

/// Reads the parts of a text such as
///
///     trot: speed=1.5, distance=2; stand: duration=1; bound: speed=0.8, distance=2
///
/// or the file that the text names, a YAML list with the same keys:
///
///     - {gait: trot, speed: 1.5, distance: 2}
///     - {gait: stand, duration: 1}
///
/// The keys have the names of the flags: speed, lateral-speed [m/s], yaw-rate [rad/s]; one of distance [m], duration
/// [s] and steps; step-length [m] with steps. If the distance is missing, a part moves 1 m, or turns by 90 degrees if
/// only its yaw rate is given. Gait names are those of FindGait; in a sequence file, paths of gait files are relative
/// to its folder. Failure kBadInput names the part, or the file and line, and what is accepted.
Result<std::vector<AskedPart>> ReadSequence(const std::string& text);

/// The file that such a text names; empty if the text contains the parts.
std::string SequenceFileOf(const std::string& text);

}  // namespace gaitwright
