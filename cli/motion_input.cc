// SPDX-License-Identifier: BSD-3-Clause
#include "cli/motion_input.h"

#include <fmt/format.h>

#include "cli/flags.h"
#include "cli/robot_input.h"
#include "kinematics/base/file.h"
#include "planning/plan/plan_json.h"
#include "playback/log/log_json.h"
#include "workflows/exchange/motion_file.h"
#include "workflows/walk/walk.h"

namespace gaitwright::cli {

void MotionRobot::AddTo(Verb verb) {
  verb.SetGroup("Robot of the motion, if the file does not name it");
  const Flag played = AddText(verb, "--plan", "FILE", plan, "The plan that was played; default none.");
  for (const Flag& flag :
       robot.AddTo(verb, "Robot by name, see 'gaitwright robots'; a plan contains its own robot; default none."))
    played.Exclude(flag);
  verb.SetGroup("Options");
}

Result<MotionInput> PlanInput(MotionPlan plan) {
  MotionInput input;
  Result<RobotModel> model = RobotOf(plan);
  if (!model) return model.failure();
  input.model = std::move(*model);
  input.plan = std::move(plan);
  return input;
}

Result<MotionInput> NamedInput(const MotionRobot& robot) {
  MotionInput input;
  if (!robot.plan.empty()) {
    Result<MotionPlan> plan = LoadPlan(robot.plan);
    if (!plan) return plan.failure();
    Result<RobotModel> model = RobotOf(*plan);
    if (!model) return model.failure();
    input.played = std::move(*plan);
    input.model = std::move(*model);
  } else if (robot.given()) {
    Result<RobotModel> model = ReadRobot(robot.robot);
    if (!model) return model.failure();
    input.model = std::move(*model);
  }
  return input;
}

Result<MotionInput> ReadMotionInput(const std::string& path, const MotionRobot& robot) {
  const Result<std::string> text = ReadFile(path);
  if (!text) return text.failure();
  const MotionFileKind kind = KindOfText(*text);
  if (kind == MotionFileKind::kPlan) {
    if (robot.given()) {
      throw InvalidArgument(fmt::format(
          "'{}' is a plan and contains its robot; --robot, --urdf, --mjcf and --plan are for logs only", path));
    }
    Result<MotionPlan> plan = PlanFromJson(*text, path);
    return plan ? PlanInput(std::move(*plan)) : plan.failure();
  }
  if (kind != MotionFileKind::kLog) {
    return Failure{FailureKind::kBadInput,
                   FailureCode::kNoMotion,
                   "ReadMotion",
                   fmt::format("'{}' is {}, neither a plan nor a log", path, NameOf(kind)),
                   {"give a plan.json or log.json, as written by 'walk'"}};
  }
  Result<PlaybackLog> log = LogFromJson(*text, path);
  if (!log) return log.failure();
  if (!robot.given()) {
    return Failure{FailureKind::kBadInput,
                   FailureCode::kNoRobot,
                   "ReadMotion",
                   fmt::format("'{}' is a log of robot '{}', but does not contain the robot", path, log->robot),
                   {"--plan FILE, the plan that was played", "--robot " + log->robot}};
  }
  Result<MotionInput> input = NamedInput(robot);
  if (input) input->log = std::move(*log);
  return input;
}

}  // namespace gaitwright::cli
