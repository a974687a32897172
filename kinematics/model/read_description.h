// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "kinematics/model/finding.h"
#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// How a robot description is read.
struct RobotLoading {
  std::string yaml_path = {};  ///< "" uses `robot.yaml` beside the description if it exists, "none" uses none
  bool strict = false;         ///< what would be mended (see MendUrdf and MendInertia) is refused
  std::map<std::string, std::string> packages = {};         ///< folders by name, before those that are found
  std::map<std::string, std::string> xacro_arguments = {};  ///< values by name
};

/// A robot description as texts that LoadRobotFromText takes.
struct RobotDescription {
  std::string urdf;
  std::string yaml;  ///< the robot.yaml, with what an MJCF says and a URDF cannot where it does not say it
  std::string yaml_without_posture;  ///< of an MJCF, whose keyframe need not stand level; else ""
  std::vector<MeshHull> meshes;      ///< hulls of the meshes that an MJCF contains itself
  std::vector<Finding> findings;     ///< on how the file was read
};

/// Reads a URDF, a xacro file, which is expanded, or an MJCF, which is converted; the content decides. Unless `strict`,
/// a text in another encoding than UTF-8 is read too. Failure: as of ReadFile, ExpandXacro and ConvertMjcf; `not_urdf`
/// for an SDF.
Result<RobotDescription> ReadDescription(const std::string& path, const RobotLoading& loading);

}  // namespace gaitwright
