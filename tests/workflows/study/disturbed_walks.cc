// SPDX-License-Identifier: BSD-3-Clause
#include "tests/workflows/study/disturbed_walks.h"

#include "kinematics/model/load_robot.h"
#include "tests/built_paths.h"
#include "workflows/study/run_trials.h"

namespace gaitwright {

RobustnessReport TriedByHobbySensors(const std::string& robot, const WalkRequest& walk, const std::string& disturbances,
                                     int trials, int seed) {
  const RobotModel model = LoadNamedRobot(robot).value();
  const MotionPlan plan = PlanWalk(model, walk).value().motion.plan;
  PlayRequest play;
  play.sensing.state = "estimated";
  play.sensing.sensors = SensorsOfKind("hobby");
  const std::string file = SourceFolder() + "/examples/disturbances/" + disturbances;
  const Disturbances drawn = LoadDisturbances(file, SensorFields(play)).value();
  TrialOptions options;
  options.trials = trials;
  options.seed = seed;
  return RunTrials({model, plan, play, drawn}, options).value();
}

}  // namespace gaitwright
