// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "cli/flags.h"
#include "cli/paths.h"
#include "playback/trials/disturbances.h"
#include "workflows/walk/walk.h"

namespace gaitwright::cli {

/// The flag --disturbances, shared by `trials` and `play`.
struct DisturbanceArguments {
  std::string file;  ///< "" for the standard set

  void AddTo(Verb verb, const std::string& otherwise = "the standard set, scaled to the robot");
  void AddPathTo(Paths& paths) const;
  /// Reads the file, or gives the standard set without the options that are set elsewhere. Failure if a disturbance
  /// cannot be played or would have no effect.
  /// @param varied  options that a study varies.
  Result<Disturbances> Load(const RobotModel& model, PlayRequest request,
                            const std::vector<std::string>& varied = {}) const;
};

}  // namespace gaitwright::cli
