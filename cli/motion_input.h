// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "cli/robot_input.h"
#include "cli/verb.h"
#include "kinematics/base/result.h"
#include "kinematics/model/robot_model.h"
#include "planning/plan/motion_plan.h"
#include "playback/log/playback_log.h"

namespace gaitwright::cli {

/// Flags that name the robot of a motion if its file does not contain it.
struct MotionRobot {
  RobotFlags robot = {.name = ""};
  std::string plan;

  void AddTo(Verb verb);
  bool given() const { return !robot.name.empty() || robot.is_file() || !plan.empty(); }
};

/// A motion that was read: a plan, or a log with the plan that was played, if known.
struct MotionInput {
  std::optional<RobotModel> model = {};
  std::optional<MotionPlan> plan = {}, played = {};
  std::optional<PlaybackLog> log = {};
};

/// The plan of a file and its robot.
Result<MotionInput> PlanInput(MotionPlan plan);

/// Reads a plan or a log (the content of the file decides), and its robot.
Result<MotionInput> ReadMotionInput(const std::string& path, const MotionRobot& robot);

/// The robot that the flags name, and the plan if they name one; both are empty if no flag is given.
Result<MotionInput> NamedInput(const MotionRobot& robot);

}  // namespace gaitwright::cli
