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
  bool strict = false;         ///< refuses errors that are otherwise repaired (see MendUrdf and MendInertia)
  std::map<std::string, std::string> packages = {};         ///< folders by name; searched before all others
  std::map<std::string, std::string> xacro_arguments = {};  ///< values by name
};

/// A robot description as texts that LoadRobotFromText takes.
struct RobotDescription {
  std::string urdf;
  std::string yaml;                  ///< the robot.yaml, completed by data of an MJCF that a URDF cannot contain
  std::string yaml_without_posture;  ///< for an MJCF, `yaml` without the posture of its keyframe; else ""
  std::vector<MeshHull> meshes;      ///< hulls of the meshes that an MJCF contains itself
  std::vector<Finding> findings;     ///< findings about reading the file
};

/// Reads a URDF, a xacro file (and expands it), or an MJCF (and converts it); the content decides which. Unless
/// `strict`, an encoding other than UTF-8 is accepted. Failure: as in ReadFile, ExpandXacro and ConvertMjcf; `not_urdf`
/// for an SDF.
Result<RobotDescription> ReadDescription(const std::string& path, const RobotLoading& loading);

}  // namespace gaitwright
