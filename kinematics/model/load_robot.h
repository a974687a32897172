// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "kinematics/model/read_description.h"
#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// The robot of a URDF, xacro or MJCF file. Errors with one clear meaning are repaired and listed in the model's
/// findings. Its collision meshes are read (see FindMeshFile). A mesh that is missing or cannot be read is a failure
/// that names the file and the link if it alone defines the shape of a foot; any other one is a finding. The robot.yaml
/// overrides derived data.
Result<RobotModel> LoadRobot(const std::string& urdf_path, const RobotLoading& loading);
Result<RobotModel> LoadRobot(const std::string& urdf_path, const std::string& yaml_path = "");

/// Loads a robot from texts.
/// @param name  used if the robot.yaml does not contain a name.
/// @param meshes  the hulls of the URDF's collision meshes, as in RobotModel::meshes.
Result<RobotModel> LoadRobotFromText(const std::string& urdf_text, const std::string& yaml_text,
                                     const std::string& name = "robot", const std::vector<MeshHull>& meshes = {},
                                     bool strict = false);

/// Loads a robot of the `robots` folder by name. The environment variable GAITWRIGHT_ROBOTS sets the folder; its
/// default is the folder that comes with the program (see DataPath). The failure for an unknown name lists the known
/// names.
Result<RobotModel> LoadNamedRobot(const std::string& name);

/// The robot with an additional link to lie on: `rests` of its robot.yaml. Failure: as in LoadRobotFromText.
Result<RobotModel> WithRest(const RobotModel& model, const std::string& link);

/// The `robots` folder.
std::string RobotsFolder();

/// Names of the robots in the `robots` folder, sorted.
std::vector<std::string> RobotNames();

}  // namespace gaitwright
