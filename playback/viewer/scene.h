// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "kinematics/model/robot_model.h"
#include "planning/plan/motion_plan.h"
#include "playback/log/playback_log.h"
#include "playback/score/stability_report.h"

namespace gaitwright {

/// Maximum sample rate of a scene; logs with a higher rate are thinned.
inline constexpr double kSceneRateHz = 200.0;

/// Another motion of the same robot, shown as a translucent robot in the picture of a motion.
struct ShownGhost {
  std::string title;                       ///< what it is: "the original"
  std::function<VectorX(double)> posture;  ///< q at a time since the start of the motion [s]; empty where it has none
};

/// A motion to show: a plan, and its playback if there is one.
struct ShownMotion {
  std::string title;
  const RobotModel& model;
  const MotionPlan& plan;
  const PlaybackLog* log = nullptr;             ///< of the plan; null shows only the plan
  const StabilityReport* report = nullptr;      ///< of the log; null shows no verdict
  std::string objection = {};                   ///< reason of a fail independent of physics; else empty
  std::optional<std::string> mesh_folder = {};  ///< of the URDF, for visual meshes; without it hulls are shown
  std::optional<ShownGhost> ghost = {};         ///< instead of the plan of a log
  double rate_hz = kSceneRateHz;                ///< of the scene's samples, at most
};

/// Data of the page of viewer_page.h, as JSON without `<`, `>` and `&`: robots with their shapes, ground, planned and
/// measured motion as packed columns, footholds, swings, marks (docs/viewer.md).
/// @throws InvalidArgument as MakeMotionSeries and Score do, and if there are no motions.
std::string SceneJson(const std::vector<ShownMotion>& motions);

/// Only the robot and the ground of such a scene: an object of `robot` and `terrain`.
std::string RobotAndGroundJson(const RobotModel& model, const Terrain& terrain,
                               const std::optional<std::string>& mesh_folder = {});

}  // namespace gaitwright
