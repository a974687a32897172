// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "cli/flags.h"
#include "cli/paths.h"
#include "playback/trials/disturbances.h"
#include "workflows/walk/walk.h"

namespace gaitwright::cli {

/// The flag --disturbances, shared by `trials` and `play`.
struct DisturbanceArguments {
  std::string file;  ///< "" for the standard set

  void AddTo(CLI::App& verb, const std::string& otherwise = "the standard set, scaled to the robot");
  void AddPathTo(Paths& paths) const;
  /// What the file says, or the standard set; a failure where some of it could not be played.
  Result<Disturbances> Load(const RobotModel& model, PlayRequest request) const;
};

}  // namespace gaitwright::cli
