// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "kinematics/model/read_description.h"
#include "kinematics/model/robot_model.h"

namespace gaitwright {

/// The robot of a URDF, xacro or MJCF file. What is wrong in it and has one plain meaning is mended, and told in the
/// model's findings. Its collision meshes are read (see FindMeshFile). One that is unreadable is a failure that names
/// the file and the link; so is a missing one that alone tells the shape of a foot. Another missing one, and a missing
/// visual mesh, is a note. The robot.yaml overrides what derivation cannot know.
Result<RobotModel> LoadRobot(const std::string& urdf_path, const RobotLoading& loading);
Result<RobotModel> LoadRobot(const std::string& urdf_path, const std::string& yaml_path = "");

/// The same from texts. @param name used where the robot.yaml gives none. @param meshes the hulls of the URDF's
/// collision meshes, as RobotModel::meshes has them.
Result<RobotModel> LoadRobotFromText(const std::string& urdf_text, const std::string& yaml_text,
                                     const std::string& name = "robot", const std::vector<MeshHull>& meshes = {},
                                     bool strict = false);

/// A robot of the `robots` folder by name. The folder is that of the environment variable GAITWRIGHT_ROBOTS, else the
/// one that comes with the program (see DataPath). An unknown name is a failure that lists what exists.
Result<RobotModel> LoadNamedRobot(const std::string& name);

/// The same robot, which may also lie on a link: `rests` of its robot.yaml. Failure as of LoadRobotFromText.
Result<RobotModel> WithRest(const RobotModel& model, const std::string& link);

/// That folder.
std::string RobotsFolder();

/// Names of the robots in that folder, sorted.
std::vector<std::string> RobotNames();

}  // namespace gaitwright
