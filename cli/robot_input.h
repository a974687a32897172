// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "cli/paths.h"
#include "cli/verb.h"
#include "kinematics/base/result.h"
#include "kinematics/model/load_robot.h"

namespace gaitwright::cli {

/// The flags that say which robot, and how its description is read.
struct RobotFlags {
  std::string name = "a1";
  std::string file = {};  ///< of a description; "" where the robot goes by its name
  RobotLoading loading = {};

  /// @param text  of `--robot`: what it is taken for, with its default. @return the flags, for others to exclude.
  std::vector<Flag> AddTo(Verb verb, const std::string& text = "Robot by name, see 'gaitwright robots'; default a1.");
  /// How a description is read; part of AddTo.
  void AddLoadingTo(Verb verb);
  bool is_file() const { return !file.empty(); }
  /// Where its meshes are looked for; "" for a robot by name.
  std::string folder() const;
  void AddTo(Paths& paths) const;
};

/// The robot of the flags. Where it is refused for what a robot.yaml can tell, a draft of one is written to
/// robot.draft.yaml in the present folder, unless there is such a file, and the failure says so.
Result<RobotModel> ReadRobot(const RobotFlags& flags);

/// The failure of a plan. Where the robot has no area to stand on, and no shape tells how its feet meet the ground, a
/// draft is written as by ReadRobot.
Failure WithDraft(Failure failure, const RobotFlags& flags, const RobotModel& model);

}  // namespace gaitwright::cli
