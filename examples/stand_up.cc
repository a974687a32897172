// SPDX-License-Identifier: BSD-3-Clause
#include "examples/stand_up.h"

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/model/load_robot.h"
#include "workflows/words/plan_tasks.h"

namespace gaitwright::examples {
namespace {

/// Where the ground's forces act, on level ground: p = (-M_y, M_x) / F_z, moments about the world's origin.
Vector2 MeasuredZmp(const RobotModel& model, const LogSample& sample) {
  DynamicsScratch scratch(model);
  ForwardKinematics(model, sample.q, scratch);
  Vector3 force = Vector3::Zero(), moment = Vector3::Zero();
  for (std::size_t f = 0; f < model.feet.size(); ++f) {
    const Vector3 p_WF = ContactFrame(model, scratch, static_cast<int>(f)).translation();
    force += sample.wrenches[f].force_W;
    moment += sample.wrenches[f].moment_W + p_WF.cross(sample.wrenches[f].force_W);
  }
  return Vector2(-moment.y(), moment.x()) / force.z();
}

}  // namespace

StoodUp StandUp(const std::string& robot, const std::function<void(const GateRecord&)>& on_phase) {
  const Result<RobotModel> model = LoadNamedRobot(robot);
  if (!model) throw InvalidArgument(model.failure().message);
  TaskPlan tasks;
  tasks.tasks = {{"stand_up", {}, "", {}}, {"stand", {{"duration_s", 1.0}}, "", {}}};
  const Result<PlannedTasks> planned = PlanTasks(*model, FlatTerrain(), tasks, {});
  if (!planned) throw InvalidArgument(planned.failure().message);
  if (planned->plan.gates.empty()) throw InvalidArgument("robot '" + robot + "' cannot lie, and so cannot get up");
  PlayRequest request;
  request.play.on_phase = on_phase;
  const Result<PlayedWalk> played = PlayWalk(planned->robot, planned->plan, request);
  if (!played) throw InvalidArgument(played.failure().message);
  const Vector2 zmp = MeasuredZmp(planned->robot, played->log.samples.back());
  return {played->log, played->report, (zmp - planned->plan.centroidal.p_WZ.back()).norm()};
}

}  // namespace gaitwright::examples
