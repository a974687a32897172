// SPDX-License-Identifier: BSD-3-Clause
// Assignment 8: a trot that survives pushes. See ../README.md. Plays options in trials, prints how many the robot
// survives, and writes the options.
//   robustness robustness.yaml
#include <fmt/format.h>

#include <string>

#include "kinematics/base/file.h"
#include "workflows/study/run_trials.h"

namespace {

using namespace gaitwright;

const OptionTexts kOptions = {
    {"pipeline.com_height_m", "0.33"},  // height of the centre of mass
};

/// Lateral pushes, on ground with different friction. See docs/trials.md.
const std::string kDisturbances =
    "friction: {uniform: [0.5, 0.9]}\n"
    "pushes:\n"
    "  - size_n: {uniform: [140, 200]}\n"
    "    direction_deg: {choice: [90, -90, 70, 110, -70, -110]}\n"
    "    at_share: {uniform: [0.2, 0.7]}\n"
    "    duration_s: 0.1\n";

Result<MotionPlan> Planned(const RobotModel& model, const OptionTexts& options) {
  WalkRequest request;
  request.gait = "trot";
  request.command.speed_m_s = 0.3;
  request.command.distance_m = 0.6;
  OptionFields fields = request.Fields();
  for (const auto& [key, text] : options) SetOption(fields, key, text);
  const Result<PlannedWalk> planned = PlanWalk(model, request);
  if (!planned) return planned.failure();
  return planned->motion.plan;
}

/// Number of survived trials with `joint-pd`, which tracks the planned joint positions and does not balance.
Result<int> Survived(const RobotModel& model, const MotionPlan& plan, int trials) {
  PlayRequest play;
  play.controller = "joint-pd";
  const Result<Disturbances> drawn = ReadDisturbances(kDisturbances, SensorFields(play), "the disturbances");
  if (!drawn) return drawn.failure();
  TrialOptions options;
  options.trials = trials;
  options.seed = 1;
  options.threads = 1;
  const Result<RobustnessReport> report = RunTrials({model, plan, play, *drawn}, options);
  if (!report) return report.failure();
  return report->survived;
}

}  // namespace

int main(int argc, char** argv) {
  constexpr int kTrials = 10;
  const Result<RobotModel> model = ChooseRobot("a1", "");
  if (!model) return 1;
  const Result<MotionPlan> plan = Planned(*model, kOptions);
  if (!plan) {
    fmt::print("no plan: {}\n", plan.failure().message);
  } else if (const Result<int> survived = Survived(*model, *plan, kTrials)) {
    fmt::print("survives {} of {} trials\n", *survived, kTrials);
  }
  std::string yaml;
  for (const auto& [key, text] : kOptions) yaml += fmt::format("{}: {}\n", key, text);
  const Result<std::string> written = WriteFileAtomically(argc > 1 ? argv[1] : "robustness.yaml", yaml);
  if (!written) fmt::print(stderr, "robustness: {}\n", written.failure().message);
  return written ? 0 : 1;
}
