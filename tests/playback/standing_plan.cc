// SPDX-License-Identifier: BSD-3-Clause
#include "tests/playback/standing_plan.h"

#include <cmath>

#include "kinematics/dynamics/contact_split.h"
#include "kinematics/dynamics/dynamics.h"
#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/model/load_robot.h"

namespace gaitwright::standing {

RobotModel Load(const std::string& name) { return LoadNamedRobot(name).value(); }

void AddRow(const RobotModel& model, const VectorX& q, WholeBodyTrajectory& trajectory) {
  DynamicsScratch scratch(model);
  const VectorX rest = VectorX::Zero(model.nv());
  VectorX tau(model.nv());
  InverseDynamics(model, q, rest, rest, scratch, tau);
  std::vector<ContactPoint> contacts;
  std::vector<int> foot_of;
  for (int foot = 0; foot < static_cast<int>(model.feet.size()); ++foot) {
    for (const Vector3& p : ContactPoints(model, scratch, foot)) {
      contacts.push_back({p, Vector3::UnitZ(), 0.8, 1.0});
      foot_of.push_back(foot);
    }
  }
  ContactSplitter splitter;
  ContactSplit split;
  splitter.Solve(contacts, {q.head<3>(), tau.head<3>(), tau.segment<3>(3)}, split);
  std::vector<ContactWrench> wrenches(model.feet.size());
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const auto foot = static_cast<std::size_t>(foot_of[i]);
    const Vector3 origin = ContactFrame(model, scratch, foot_of[i]).translation();
    wrenches[foot].force_W += split.force_W[i];
    wrenches[foot].moment_W += (contacts[i].p_W - origin).cross(split.force_W[i]);
    AddPointForce(model, scratch, model.feet[foot].body, contacts[i].p_W, -split.force_W[i], tau);
  }
  trajectory.q.push_back(q);
  trajectory.v.push_back(rest);
  trajectory.a.push_back(rest);
  trajectory.tau.push_back(tau.tail(model.num_dofs()));
  trajectory.wrenches.push_back(wrenches);
}

MotionPlan Plan(const RobotModel& model, double duration_s) {
  MotionPlan plan;
  plan.robot = model.name;
  plan.robot_hash = model.hash;
  plan.terrain = FlatTerrain();
  plan.whole_body.step_s = 0.005;
  AddRow(model, StandingConfiguration(model), plan.whole_body);
  const auto rows = static_cast<std::size_t>(std::lround(duration_s / plan.whole_body.step_s)) + 1;
  WholeBodyTrajectory& w = plan.whole_body;
  w.q.resize(rows, w.q.front());
  w.v.resize(rows, w.v.front());
  w.a.resize(rows, w.a.front());
  w.tau.resize(rows, w.tau.front());
  w.wrenches.resize(rows, w.wrenches.front());
  plan.schedule.phases = {{0.0, duration_s, AllFeet(static_cast<int>(model.feet.size()))}};
  return plan;
}

}  // namespace gaitwright::standing
