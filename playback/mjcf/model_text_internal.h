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

/// Identity of a geom of the robot, for reading contacts.
struct GeomPart {
  int foot = -1;     ///< index of the foot that the geom belongs to, or -1
  std::string link;  ///< URDF link
};

/// A robot on a ground as the text of a MuJoCo file.
///
/// Bodies, joints and frames are those of RobotModel, so that states differ only in the base's quaternion and angular
/// velocity. Bodies and joints have the model's names, escaped as XML. Geoms of the robot are `g<i>` with i the index
/// into `parts`; geoms of the ground are `t<i>`.
struct ModelText {
  std::string mjcf;
  std::vector<GeomPart> parts;
  std::vector<std::string> solids;  ///< names of the ground's geoms, see SolidNames
  std::vector<FieldHeights> fields;
};

/// Parts of a file that our own world computes itself.
struct FileParts {
  VectorX stiffness, damping;        ///< of the motors, by coordinate
  std::vector<std::string> heights;  ///< file of each height field
};

/// @param q  configuration at which locked joints are welded; its x and y are the start point of slope and bumps.
/// @param parts  null for our own world, which computes motors, joint losses and position limits itself. Otherwise
/// these are written too, with `q` as the first key frame.
ModelText WriteModel(const RobotModel& model, const Terrain& terrain, const VectorX& q, const WorldOptions& options,
                     const FileParts* parts = nullptr);

}  // namespace gaitwright::mujoco
