// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kinematics/model/robot_model.h"
#include "planning/plan/motion_plan.h"
#include "playback/log/playback_log.h"
#include "playback/score/stability_report.h"

namespace gaitwright {

/// A motion to show: a plan, with its playback if known.
struct ShownMotion {
  std::string title;
  const RobotModel& model;
  const MotionPlan& plan;
  const PlaybackLog* log = nullptr;             ///< of the plan; null shows the plan alone
  const StabilityReport* report = nullptr;      ///< of the log; null shows no verdict
  std::string objection = {};                   ///< reason of a fail independent of physics; empty for none
  std::optional<std::string> mesh_folder = {};  ///< of the URDF, to look for visual meshes; without it hulls are shown
};

/// Most samples of a second that a scene keeps: a log of a higher rate is thinned.
inline constexpr double kSceneRateHz = 200.0;

/// What the page of viewer_page.h shows, as JSON without `<`, `>` and `&`: robots with their shapes, ground, planned
/// and measured motion as packed columns, footholds, swings, marks (docs/viewer.md).
/// @throws InvalidArgument as MakeMotionSeries and Score do, and without motions.
std::string SceneJson(const std::vector<ShownMotion>& motions);

/// The robot and the ground of such a scene alone: an object of `robot` and `terrain`.
std::string RobotAndGroundJson(const RobotModel& model, const Terrain& terrain,
                               const std::optional<std::string>& mesh_folder = {});

}  // namespace gaitwright
