// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "playback/viewer/scene.h"

namespace gaitwright::cli {

/// A plan or a log that is to be seen, with all that a picture of it needs.
struct MotionToShow {
  RobotModel model;
  MotionPlan plan;
  std::optional<PlaybackLog> log = {};
  std::optional<StabilityReport> report = {};
  std::string title;

  ShownMotion Shown(const std::optional<std::string>& mesh_folder) const;
};

/// Reads a plan, or a log with the plan that was played: `plan_path`, or "" for the plan.json beside the log. A log is
/// scored. Failures of the readers; a file that is neither; a log without its plan, or with another.
Result<MotionToShow> ReadMotionToShow(const std::string& path, const std::string& plan_path);

/// What was said beside motions and is of no use with them. @throws InvalidArgument for a plan of a log where no motion
/// is one, and for a folder of meshes that is none.
void CheckShown(const std::vector<MotionToShow>& motions, const std::string& plan_path, const std::string& mesh_folder);

}  // namespace gaitwright::cli
