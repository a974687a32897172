// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "kinematics/model/robot_model.h"
#include "planning/plan/motion_plan.h"
#include "playback/log/playback_log.h"
#include "playback/score/motion_series.h"

namespace gaitwright {

/// Tree, joints and shapes of a robot: what the URDF says it looks like, where that can be drawn, else what it
/// touches with. A visual mesh is looked for from `mesh_folder`; where it is not to be had, the link's collision
/// shapes stand in.
nlohmann::ordered_json RobotScene(const RobotModel& model, const std::optional<std::string>& mesh_folder);

nlohmann::ordered_json TerrainScene(const Terrain& terrain);

/// The times, and the planned and measured motion at every `stride`-th sample; a side without samples is null.
struct TrackScenes {
  nlohmann::ordered_json time_s, planned, measured;
};
TrackScenes TracksScene(const RobotModel& model, const MotionPlan& plan, const PlaybackLog* log,
                        const MotionSeries& series, std::size_t stride);

nlohmann::ordered_json FootholdsScene(const RobotModel& model, const MotionPlan& plan);
nlohmann::ordered_json SwingsScene(const MotionPlan& plan);

}  // namespace gaitwright
