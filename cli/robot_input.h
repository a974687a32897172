// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "cli/paths.h"
#include "cli/verb.h"
#include "kinematics/base/result.h"
#include "kinematics/model/load_robot.h"

namespace gaitwright::cli {

/// Flags that choose the robot and say how to read its description.
struct RobotFlags {
  std::string name = "a1";
  std::string file = {};  ///< file of the robot description; "" if the robot is given by name
  RobotLoading loading = {};

  /// @param text  help of `--robot`, with its default. @return the flags, for other flags to exclude.
  std::vector<Flag> AddTo(Verb verb, const std::string& text = "Robot by name, see 'gaitwright robots'; default a1.");
  /// Adds the flags that say how to read a description; part of AddTo.
  void AddLoadingTo(Verb verb);
  bool is_file() const { return !file.empty(); }
  /// Folder where the meshes are searched; "" for a robot by name.
  std::string folder() const;
  void AddTo(Paths& paths) const;
};

/// Reads the robot of the flags. If it is refused for lack of data that a robot.yaml can give, this writes a draft to
/// robot.draft.yaml in the current folder, unless that file exists, and the failure says so.
Result<RobotModel> ReadRobot(const RobotFlags& flags);

/// Returns the failure of a plan. If the robot has no support area and no collision shape of its feet, this writes a
/// draft as ReadRobot does.
Failure WithDraft(Failure failure, const RobotFlags& flags, const RobotModel& model);

}  // namespace gaitwright::cli
