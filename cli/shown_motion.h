// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "playback/viewer/scene.h"

namespace gaitwright::cli {

/// A plan or a log to show, with all data that a picture of it needs.
struct MotionToShow {
  RobotModel model;
  MotionPlan plan;
  std::optional<PlaybackLog> log = {};
  std::optional<StabilityReport> report = {};
  std::string title;

  ShownMotion Shown(const std::optional<std::string>& mesh_folder) const;
  /// This motion as a ghost of another, on which the times since the starts are equal. It must outlive the ghost.
  ShownGhost AsGhost() const;
};

/// Reads a plan, or a log with the plan that was played: `plan_path`, or "" for the plan.json beside the log. A log is
/// also scored. Failures: as of the readers; for a file that is neither; for a log without its plan or with another
/// plan.
Result<MotionToShow> ReadMotionToShow(const std::string& path, const std::string& plan_path);

/// Checks the other flags against the motions. @throws InvalidArgument if a plan is given but no motion is a log, and
/// if the folder of meshes is not a folder.
void CheckShown(const std::vector<MotionToShow>& motions, const std::string& plan_path, const std::string& mesh_folder);

}  // namespace gaitwright::cli
