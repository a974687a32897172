// SPDX-License-Identifier: BSD-3-Clause
#include "examples/instruction.h"

#include "kinematics/model/load_robot.h"
#include "workflows/words/interpret.h"

namespace gaitwright::examples {

Obeyed Obey(const std::string& instruction, const std::string& robot) {
  const Result<RobotModel> model = LoadNamedRobot(robot);
  if (!model) throw InvalidArgument(model.failure().message);
  const Grammar grammar;
  const Result<Interpretation> tasks = InterpretBy({&grammar}, instruction, ScopeOf(*model));
  if (!tasks) throw InvalidArgument(tasks.failure().message);
  const Result<PlannedTasks> planned = PlanTasks(*model, FlatTerrain(), tasks->plan, {});
  if (!planned) throw InvalidArgument(planned.failure().message);
  const PlayRequest request;
  const Result<PlayedWalk> played = PlayWalk(planned->robot, planned->plan, request);
  if (!played) throw InvalidArgument(played.failure().message);
  return {tasks->plan, played->report};
}

}  // namespace gaitwright::examples
