// SPDX-License-Identifier: BSD-3-Clause
#include "cli/study_arguments.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/robot_input.h"
#include "planning/gait/find_gait.h"
#include "workflows/study/trial.h"

namespace gaitwright::cli {
namespace {

/// @throws InvalidArgument if --set or a flag sets the option that the axis varies, since it would have no effect. A
/// zero component of --push counts as not set.
void CheckGivenOnce(const StudyAxis& axis, const StudyArguments& a, const std::vector<std::string>& sets) {
  std::vector<std::string> given;
  for (const std::string& set : sets) {
    if (set.starts_with(axis.key + "=")) given.push_back("--set " + set);
  }
  for (const std::vector<KeyedFlag>* flags : {&a.walk.keyed, &a.play.keyed}) {
    for (const auto& [flag, key] : *flags) {
      if (key == axis.key && flag.given()) given.push_back(flag.name());
    }
  }
  const char* const push[] = {"play.push_force_x_n", "play.push_force_y_n", "play.push_force_z_n"};
  for (int i = 0; i < 3; ++i) {
    if (axis.key == push[i] && !a.play.push.empty() && a.play.request.play.push_force_W[i] != 0.0)
      given.emplace_back("--push");
  }
  if (given.empty()) return;
  throw InvalidArgument(fmt::format("{} sets what --over {} varies; leave one of them out", given.front(), axis.key));
}

}  // namespace

void StudyArguments::AddTo(Verb verb, const std::string& over_help) {
  walk.AddTo(verb);
  verb.SetGroup("Varied options");
  verb.AddValue("--over", over, over_help).SetType("KEY=VALUES").Repeat().Require();
  verb.SetGroup("Options");
}

void StudyArguments::AddWorkTo(Verb verb) {
  play.AddTo(verb);
  options.AddTo(verb);
  verb.SetGroup("Execution");
  AddWholeNumber(verb, "--threads", 0, threads,
                 "Number of threads, which does not change the result; default 0: one per core.");
  verb.AddSwitch("--resume", resume, "Continue an interrupted run; the result equals that of an uninterrupted one.");
}

OptionFields StudyArguments::Fields() { return Joined({walk.Fields(), play.Fields()}); }

Paths StudyArguments::PathsToRead() const {
  Paths paths;
  walk.robot.AddTo(paths);
  paths.AddGait(walk.request.gait);
  paths.AddSequence(walk.request.sequence);
  paths.AddTerrain(walk.request.terrain);
  options.AddPathTo(paths);
  disturbances.AddPathTo(paths);
  return paths;
}

Result<OptionTexts> StudyArguments::Finish(const std::vector<StudyAxis>& axes, const Common& common) {
  play.SetDefaults(common);
  walk.request.seed = static_cast<std::uint64_t>(common.seed);
  Result<OptionTexts> texts = options.Apply(Fields(), common);
  if (!texts) return texts;
  ApplySets("--set", common.sets, Fields());
  const std::vector<std::string> varied = KeysOf(axes);
  play.Finish(varied);
  for (const StudyAxis& axis : axes) {
    CheckGivenOnce(axis, *this, common.sets);
    if (axis.key == "step_length" && !walk.extent.steps)
      throw InvalidArgument("--over step_length is for counted steps: give --steps too");
    if (!walk.request.sequence.empty() && IsOfCommand(axis.key)) {
      throw InvalidArgument(
          fmt::format("--over {}: the parts of a --sequence set their own speeds; vary other options", axis.key));
    }
  }
  return texts;
}

Result<RobotModel> StudyArguments::FinishFor(const std::vector<StudyAxis>& axes) {
  Result<RobotModel> model = ReadRobot(walk.robot);
  if (!model) return model;
  const Result<double> stride_m = OwnStride(*model, walk.request.gait);
  if (!stride_m) return stride_m.failure();  // report an unknown gait once, not at each point
  const WalkCommand given = walk.request.command;
  OptionFields command = CommandFields(walk.request);
  for (const StudyAxis& axis : axes) {
    if (axis.key == "step_length") walk.extent.step_length_m = axis.high;
    for (OptionField& field : command) {
      if (field.key == axis.key) *std::get<double*>(field.target) = axis.high != 0.0 ? axis.high : axis.low;
    }
  }
  walk.Finish(*model);
  for (const StudyAxis& axis : axes) {  // each point sets the varied options
    if (axis.key == "speed") walk.request.command.speed_m_s = given.speed_m_s;
    if (axis.key == "lateral_speed") walk.request.command.lateral_speed_m_s = given.lateral_speed_m_s;
    if (axis.key == "yaw_rate") walk.request.command.yaw_rate_rad_s = given.yaw_rate_rad_s;
  }
  return model;
}

TrialPlayer PlayerOf(const Disturbances& disturbances, int run_seed) {
  return [disturbances, run_seed](const RobotModel& model, const MotionPlan& plan, const PlayRequest& request,
                                  int number) -> Result<TrialWorth> {
    const std::uint64_t seed = SeedOfTrial(static_cast<std::uint64_t>(run_seed), number);
    const Result<PlayedTrial> trial = PlayTrial({model, plan, request, disturbances}, number, seed);
    if (!trial) return trial.failure();
    return TrialWorth{trial->outcome.score, trial->outcome.survived};
  };
}

}  // namespace gaitwright::cli
