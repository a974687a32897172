// SPDX-License-Identifier: BSD-3-Clause
// A solution of assignment 8: a robot with a lower body and a lower swing withstands larger pushes. Plays combinations
// of both heights in trials, and writes the best.
//   robustness robustness.yaml
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "kinematics/base/file.h"
#include "workflows/study/run_trials.h"

namespace {

using namespace gaitwright;

/// Lateral pushes, on ground with different friction. See docs/trials.md.
const std::string kDisturbances =
    "friction: {uniform: [0.5, 0.9]}\n"
    "pushes:\n"
    "  - size_n: {uniform: [140, 200]}\n"
    "    direction_deg: {choice: [90, -90, 70, 110, -70, -110]}\n"
    "    at_share: {uniform: [0.2, 0.7]}\n"
    "    duration_s: 0.1\n";

/// Heights of body and swing, from high to low. A lower swing foot is on the ground again sooner after a push.
std::vector<OptionTexts> Candidates() {
  std::vector<OptionTexts> candidates;
  for (const char* height : {"0.21", "0.19", "0.17"}) {
    for (const char* lift : {"0.05", "0.03"})
      candidates.push_back({{"pipeline.com_height_m", height}, {"swing.height_m", lift}});
  }
  return candidates;
}

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
  constexpr int kTrials = 8;
  const Result<RobotModel> model = ChooseRobot("a1", "");
  if (!model) return 1;
  OptionTexts best;
  int most = -1;
  for (const OptionTexts& options : Candidates()) {
    const Result<MotionPlan> plan = Planned(*model, options);
    if (!plan) continue;
    const Result<int> survived = Survived(*model, *plan, kTrials);
    if (!survived) continue;
    fmt::print("body {} m, lift {} m: survives {} of {} trials\n", options[0].second, options[1].second, *survived,
               kTrials);
    if (*survived >= most) best = options;  // of equal results the last, which is the lower one
    most = std::max(most, *survived);
  }
  std::string yaml;
  for (const auto& [key, text] : best) yaml += fmt::format("{}: {}\n", key, text);
  const Result<std::string> written = WriteFileAtomically(argc > 1 ? argv[1] : "robustness.yaml", yaml);
  if (!written) fmt::print(stderr, "robustness: {}\n", written.failure().message);
  return written ? 0 : 1;
}
