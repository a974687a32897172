// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "kinematics/model/robot_model.h"
#include "planning/plan/motion_plan.h"
#include "playback/log/playback_log.h"
#include "playback/score/motion_series.h"
#include "playback/viewer/scene.h"

namespace gaitwright {

/// Tree, joints and shapes of a robot: the visual shapes of the URDF if they can be drawn, otherwise its collision
/// shapes. Visual meshes are searched for from `mesh_folder`; if a mesh is missing, the link's collision shapes are
/// used.
nlohmann::ordered_json RobotScene(const RobotModel& model, const std::optional<std::string>& mesh_folder);

nlohmann::ordered_json TerrainScene(const Terrain& terrain);

/// The times, and the planned and measured motion at every `stride`-th sample; a motion without samples is null.
struct TrackScenes {
  nlohmann::ordered_json time_s, planned, measured;
};
TrackScenes TracksScene(const RobotModel& model, const MotionPlan& plan, const PlaybackLog* log,
                        const MotionSeries& series, std::size_t stride);

/// Postures of a ghost at the same samples, with gaps where it has none. @throws InvalidArgument for another size of q.
nlohmann::ordered_json GhostScene(const ShownMotion& shown, const MotionSeries& series, std::size_t stride);

nlohmann::ordered_json FootholdsScene(const RobotModel& model, const MotionPlan& plan);
nlohmann::ordered_json SwingsScene(const MotionPlan& plan);

}  // namespace gaitwright
