// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// A requested part of a sequence: a gait by name with a command, or standing still for the command's duration.
struct AskedPart {
  std::string gait;  ///< as FindGait takes it; "stand" for standing still
  WalkCommand command;

  bool stands() const { return gait == "stand"; }
  bool operator==(const AskedPart&) const = default;
};

/// The parts of a text such as
///
///     trot: speed=1.5, distance=2; stand: duration=1; bound: speed=0.8, distance=2
///
/// or of the file that it names, a YAML list of the same:
///
///     - {gait: trot, speed: 1.5, distance: 2}
///     - {gait: stand, duration: 1}
///
/// Keys are those of the flags: speed, lateral-speed [m/s], yaw-rate [rad/s]; one of distance [m], duration [s] and
/// steps, with step-length [m]. Without any of these, a part moves 1 m, or makes a quarter turn if only its yaw rate is
/// given. Gaits of files are named as FindGait takes them, in a file from its own folder. Failure kBadInput names the
/// part, or file and line, and what is accepted.
Result<std::vector<AskedPart>> ReadSequence(const std::string& text);

/// The file that such a text names; empty if the text contains the parts.
std::string SequenceFileOf(const std::string& text);

}  // namespace gaitwright
