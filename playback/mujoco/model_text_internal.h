// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/model/robot_model.h"
#include "planning/plan/terrain.h"
#include "playback/engine/bumps.h"
#include "playback/engine/world_options.h"

namespace gaitwright::mujoco {

/// What a geom of the robot is, for what reads its contacts.
struct GeomPart {
  int foot = -1;     ///< index of the foot that it is part of, -1 for none
  std::string link;  ///< URDF link
};

/// A height field of the world: MuJoCo reads its heights from memory, not from its text.
struct FieldHeights {
  int rows = 0, columns = 0;
  std::vector<float> heights;  ///< row by row, from 0 to 1 of the field's rise
};

/// A robot on a ground as a file of MuJoCo.
///
/// Bodies, joints and frames are those of RobotModel, so that states need no change but of the base's quaternion and
/// its angular velocity. Names: body `b<i>` and joint `j<i>` by index, geom `g<i>` by index into `parts`, ground
/// `t<i>`. Motors, losses of joints and position limits of mimicking joints are not in it: see MujocoWorld.
struct ModelText {
  std::string mjcf;
  std::vector<GeomPart> parts;
  std::vector<FieldHeights> fields;
};

/// @param q  configuration at which locked joints are welded; its x and y are where slope and bumps begin.
ModelText WriteModel(const RobotModel& model, const Terrain& terrain, const VectorX& q, const WorldOptions& options);

}  // namespace gaitwright::mujoco
