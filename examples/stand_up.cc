// SPDX-License-Identifier: BSD-3-Clause
#include "examples/stand_up.h"

#include "kinematics/model/load_robot.h"
#include "playback/score/motion_series.h"
#include "workflows/words/plan_tasks.h"

namespace gaitwright::examples {
StoodUp StandUp(const std::string& robot, const std::function<void(const GateRecord&)>& on_phase) {
  const Result<RobotModel> model = LoadNamedRobot(robot);
  if (!model) throw InvalidArgument(model.failure().message);
  TaskPlan tasks;
  tasks.tasks = {{"stand_up", {}, "", {}}, {"stand", {{"duration_s", 1.0}}, "", {}}};
  const Result<PlannedTasks> planned = PlanTasks(*model, FlatTerrain(), tasks, {});
  if (!planned) throw InvalidArgument(planned.failure().message);
  if (planned->plan.gates.empty())
    throw InvalidArgument("robot '" + robot + "' has no lying posture, so it cannot stand up from lying");
  PlayRequest request;
  request.play.on_phase = on_phase;
  const Result<PlayedWalk> played = PlayWalk(planned->robot, planned->plan, request);
  if (!played) throw InvalidArgument(played.failure().message);
  const Vector2 zmp = MakeMotionSeries(planned->robot, planned->plan, played->log, {}).measured.back().p_WZ;
  return {played->log, played->report, (zmp - planned->plan.centroidal.p_WZ.back()).norm()};
}

}  // namespace gaitwright::examples
