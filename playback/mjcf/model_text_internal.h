// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/model/robot_model.h"
#include "planning/plan/terrain.h"
#include "playback/engine/bumps.h"
#include "playback/engine/world_options.h"
#include "playback/mjcf/ground_text_internal.h"

namespace gaitwright::mujoco {

/// What a geom of the robot is, for what reads its contacts.
struct GeomPart {
  int foot = -1;     ///< index of the foot that it is part of, -1 for none
  std::string link;  ///< URDF link
};

/// A robot on a ground as a file of MuJoCo.
///
/// Bodies, joints and frames are those of RobotModel, so that states need no change but of the base's quaternion and
/// its angular velocity. Bodies and joints have the model's names, escaped as XML; geoms are `g<i>` by index into
/// `parts`, ground is `t<i>`.
struct ModelText {
  std::string mjcf;
  std::vector<GeomPart> parts;
  std::vector<std::string> solids;  ///< names of the ground's geoms, see SolidNames
  std::vector<FieldHeights> fields;
};

/// What a file has that a world of ours does itself.
struct FileParts {
  VectorX stiffness, damping;        ///< of the motors, by coordinate
  std::vector<std::string> heights;  ///< file of each height field
};

/// @param q  configuration at which locked joints are welded; its x and y are where slope and bumps begin.
/// @param parts  null for a world, which has motors, losses of joints and their position limits of its own; else these
/// are written too, with `q` as the first key frame.
ModelText WriteModel(const RobotModel& model, const Terrain& terrain, const VectorX& q, const WorldOptions& options,
                     const FileParts* parts = nullptr);

}  // namespace gaitwright::mujoco
