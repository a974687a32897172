// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/base/file.h"
#include "kinematics/model/robot_model.h"
#include "planning/plan/terrain.h"
#include "playback/engine/world_options.h"

namespace gaitwright {

/// A robot on a ground as files of MuJoCo 2.2.2 or later: the model that this program plays, for use in other programs.
///
/// Inertias, joints, contact shapes and contact settings are those of the world in MuJoCo. The file also has the
/// position limits of joints, their damping, dry friction and rotor inertia, position actuators with the gains and the
/// effort limits, and the key frame "start". It does not contain torque-speed curves, continuous torques and
/// transmissions; each joint of a transmission gets its own actuator.
/// @param q  configuration of the key frame.
/// @param stiffness, damping  by coordinate, as from DeriveGains (control/gains.h).
/// @param path  of the model; each height field is a file beside it: STEM_field0.bin.
/// @return the model, then the height fields.
std::vector<OutputFile> MujocoFiles(const RobotModel& model, const Terrain& terrain, const VectorX& q,
                                    const VectorX& stiffness, const VectorX& damping, const std::string& path);

/// A ground without a robot as files of MuJoCo 2.2.2 or later, to load or to include in a model: the ground of
/// MujocoFiles.
///
/// Geoms have the names of the ground's parts, plus a number where names would be equal. They collide with all geoms
/// whose contype or conaffinity has bit 0, which is the default. Their own friction applies. The file sets no options
/// and no defaults, and its geoms and meshes do not depend on those of an including file.
/// @param path  of the file; each height field is a file beside it: STEM_field0.bin.
/// @return the ground, then the height fields.
std::vector<OutputFile> MujocoGroundFiles(const Terrain& terrain, const std::string& path);

}  // namespace gaitwright
