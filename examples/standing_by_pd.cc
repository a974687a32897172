// SPDX-License-Identifier: BSD-3-Clause
#include "examples/standing_by_pd.h"

#include <cmath>

#include "kinematics/dynamics/dynamics.h"
#include "optimisation/pipeline/plan_posture.h"
#include "planning/tasks/repertoire.h"
#include "workflows/walk/walk.h"

namespace gaitwright::examples {
namespace {

/// For each leg, its last joint that pitches the sole.
std::vector<std::size_t> AnklesOf(const RobotModel& model, const DynamicsScratch& standing) {
  std::vector<std::size_t> ankles;
  for (const Leg& leg : model.legs) {
    int ankle = -1;
    for (const int j : leg.joints)
      if (std::abs(standing.axis_W[static_cast<std::size_t>(j)].y()) > 0.9) ankle = j;
    if (ankle < 0 || !model.feet[static_cast<std::size_t>(leg.foot)].has_sole())
      throw InvalidArgument("robot '" + model.name + "' has no ankle and sole at its leg '" + leg.name + "'");
    ankles.push_back(static_cast<std::size_t>(ankle));
  }
  return ankles;
}

/// m g (c - p_WA) in standing, where m and c are the mass and centre of mass of the robot without its feet [N m].
Vector3 LoadOn(const Vector3& p_WA, const RobotModel& model, const DynamicsScratch& standing) {
  Vector3 load = model.weight_n() * (CentreOfMass(model, standing) - p_WA);
  for (const Foot& foot : model.feet) {
    const auto b = static_cast<std::size_t>(foot.body);
    load -= kGravity * model.bodies[b].mass * (standing.p_WB[b] + standing.R_WB[b] * model.bodies[b].p_BC - p_WA);
  }
  return load;
}

}  // namespace

StoodByPd StandByPd(const RobotModel& model, double stiffness_scale, bool only_ankles) {
  Result<MotionPlan> plan = PlanPosture(model, Hold(StandingKey(model), 5.0), {});
  if (!plan) throw InvalidArgument(plan.failure().message);
  for (VectorX& tau : plan->whole_body.tau) tau.setZero();  // no feed-forward
  DynamicsScratch scratch(model);
  ForwardKinematics(model, plan->whole_body.q.front(), scratch);
  const std::vector<std::size_t> ankles = AnklesOf(model, scratch);
  PlayRequest request;
  request.controller = "joint-pd";
  request.gains = {.stiffness_scale = stiffness_scale, .damping_scale = std::sqrt(stiffness_scale)};
  std::vector<int>& welded = request.play.world.locked_dofs;
  for (int dof = 0; only_ankles && dof < model.num_dofs(); ++dof) welded.push_back(dof);
  for (const std::size_t j : ankles) std::erase(welded, model.joints[j].dof);
  const Result<PlayedWalk> played = PlayWalk(model, *plan, request);
  if (!played) throw InvalidArgument(played.failure().message);
  const VectorX stiffness = DeriveGains(model, request.gains).stiffness;
  const VectorX sagged = played->log.samples.back().q - plan->whole_body.q.front();
  StoodByPd stood;
  for (const std::size_t j : ankles) {
    stood.ankles_nm_rad += stiffness[model.joints[j].dof];
    stood.lean_rad -= scratch.axis_W[j].y() * sagged[7 + model.joints[j].dof] / static_cast<double>(ankles.size());
  }
  const Vector3 load = LoadOn(scratch.p_WB[ankles.front() + 1], model, scratch);
  stood.needed_nm_rad = load.z();
  stood.lean_formula_rad = load.x() / (stood.ankles_nm_rad - load.z());
  stood.sag_m = -sagged.z();
  stood.stands = played->report.At("fell").value == 0.0;
  return stood;
}

double LeastScale(const RobotModel& model, bool only_ankles) {
  double falls = 0.01, stands = 1.0;
  while (stands > 1.04 * falls) {
    const double between = std::sqrt(falls * stands);
    (StandByPd(model, between, only_ankles).stands ? stands : falls) = between;
  }
  return stands;
}

}  // namespace gaitwright::examples
