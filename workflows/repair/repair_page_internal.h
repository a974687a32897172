// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "playback/report/plots.h"
#include "workflows/repair/repair_report_internal.h"

namespace gaitwright {

/// Data of a page that a result does not have.
struct RepairPageWords {
  std::string source;                           ///< file of the motion
  std::string refused = {};                     ///< why no repair was possible; "" if it was, or was not tried
  std::optional<std::string> mesh_folder = {};  ///< of the robot's URDF, to find its visual meshes
};

/// A repair as one HTML page: verdict, the motion in 3D with the original as a ghost, failing checks before and after
/// over time, the distance from the original by part of the robot, changes, parts that could not be saved, and the
/// verdicts of the engines. A result without a repaired motion gives the first half, with the original in 3D if
/// MotionFindings::plan was kept. Self-contained; well-formed XML.
std::string RepairPage(const RepairResult& result, const RepairPageWords& words);

/// What could not be saved: parts that were left out, checks that still fail, falls, feet out of reach, and the reason
/// of a refusal; a sentence for each.
std::vector<std::string> UnsavedParts(const RepairResult& result, const std::string& refused);

/// Times at which checks fail, in the original and in the repaired motion, as bars in a row for each check. The SVG is
/// empty if no check fails.
Plot BrokenPlot(const RepairResult& result);

/// Distance of the repaired motion from the original over time by part of the robot: joints, then places.
Plot DistancePlot(const MotionDistance& distance, double step_s);

}  // namespace gaitwright
