// SPDX-License-Identifier: BSD-3-Clause
#include "examples/trials.h"

#include <algorithm>

#include "kinematics/model/load_robot.h"
#include "workflows/study/run_trials.h"

namespace gaitwright::examples {
namespace {

const TrialOutcome& WorstOf(const std::vector<TrialOutcome>& outcomes) {
  return *std::min_element(outcomes.begin(), outcomes.end(),
                           [](const TrialOutcome& a, const TrialOutcome& b) { return a.score < b.score; });
}

}  // namespace

TriedWalk TryWalk(const std::string& robot, const std::string& disturbances, int trials, int seed) {
  const Result<RobotModel> model = LoadNamedRobot(robot);
  if (!model) throw InvalidArgument(model.failure().message);
  WalkRequest request;
  request.command.distance_m = 1.0;
  const Result<PlannedWalk> planned = PlanWalk(*model, request);
  if (!planned) throw InvalidArgument(planned.failure().message);

  PlayRequest play;
  play.sensing.state = "estimated";
  play.sensing.sensors = SensorsOfKind("hobby");
  const Result<Disturbances> drawn = LoadDisturbances(disturbances, SensorFields(play));
  if (!drawn) throw InvalidArgument(drawn.failure().message);

  const TrialStudy study = {*model, planned->motion.plan, play, *drawn};
  TrialOptions options;
  options.trials = trials;
  options.seed = seed;
  const Result<RobustnessReport> report = RunTrials(study, options);
  if (!report) throw InvalidArgument(report.failure().message);
  const TrialOutcome& worst = WorstOf(report->outcomes);
  const Result<PlayedTrial> repeated = PlayTrial(study, worst.number, worst.seed);
  if (!repeated) throw InvalidArgument(repeated.failure().message);
  return {*report, worst, repeated->outcome};
}

}  // namespace gaitwright::examples
