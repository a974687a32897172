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
  /// What the file says, or the standard set but for what else says it; a failure where some of it could not be played,
  /// or would act on nothing.
  /// @param varied  options that a study gives one value after another.
  Result<Disturbances> Load(const RobotModel& model, PlayRequest request,
                            const std::vector<std::string>& varied = {}) const;
};

}  // namespace gaitwright::cli
