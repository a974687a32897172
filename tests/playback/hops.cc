// SPDX-License-Identifier: BSD-3-Clause
#include "tests/playback/hops.h"

#include <bit>
#include <cmath>

namespace gaitwright::synthetic {

MotionPlan HoppingPlan(const RobotModel& model, const Hops& hops) {
  const FootSet all = AllFeet(static_cast<int>(model.feet.size()));
  const double thrust = kGravity * hops.flight_s / hops.stance_s;  // [m/s^2]
  MotionPlan plan = StandingPlan(model, 0.0);
  const VectorX q0 = plan.whole_body.q.front();
  plan.schedule.phases.clear();
  WholeBodyTrajectory& body = plan.whole_body;
  body = {};
  body.step_s = kStep;
  double z = kHeight, v = 0.0;
  const auto add_row = [&](double a, FootSet stance) {
    VectorX q = q0, rate = VectorX::Zero(model.nv()), push = rate;
    q[2] = z;
    rate[2] = v;
    push[2] = a;
    VectorX tau = VectorX::Zero(model.num_dofs());
    std::vector<ContactWrench> wrenches(model.feet.size());
    for (std::size_t f = 0; f < model.feet.size(); ++f) {
      const Eigen::Index down = 3 * static_cast<Eigen::Index>(f) + 2;
      q[7 + down] += kHeight - z;
      rate[6 + down] = -v;
      push[6 + down] = -a;
      if (!Contains(stance, static_cast<int>(f))) continue;
      wrenches[f].force_W.z() = model.total_mass_kg * (a + kGravity) / std::popcount(stance);
      tau[down] = -wrenches[f].force_W.z();
    }
    body.q.push_back(q);
    body.v.push_back(rate);
    body.a.push_back(push);
    body.tau.push_back(tau);
    body.wrenches.push_back(wrenches);
  };
  const auto add = [&](double duration_s, double a, FootSet stance) {
    const double start_s = plan.schedule.phases.empty() ? 0.0 : plan.schedule.phases.back().end_s;
    const int rows = static_cast<int>(std::lround(duration_s / kStep));
    for (int k = 0; k < rows; ++k) {
      add_row(a, stance);
      z += kStep * (v + 0.5 * kStep * a);
      v += kStep * a;
    }
    if (!plan.schedule.phases.empty() && plan.schedule.phases.back().stance == stance) {
      plan.schedule.phases.back().end_s = start_s + rows * kStep;
    } else {
      plan.schedule.phases.push_back({start_s, start_s + rows * kStep, stance});
    }
  };
  add(hops.rest_s, 0.0, all);
  add(0.5 * hops.stance_s, thrust, all);
  for (int i = 0; i < hops.count; ++i) {
    add(hops.flight_s, -kGravity, 0);
    add(hops.stance_s, thrust, hops.groups[static_cast<std::size_t>(i) % hops.groups.size()]);
  }
  add(hops.flight_s, -kGravity, 0);
  add(0.5 * hops.stance_s, thrust, all);
  add(hops.rest_s, 0.0, all);
  add_row(0.0, all);
  Motion motion;
  std::vector<Vector3> feet;
  for (std::size_t i = 0; i < model.feet.size(); ++i) feet.push_back(model.joints[3 * i].X_PJ.translation());
  motion.foot.assign(body.q.size(), feet);
  plan.footsteps.footholds.clear();
  FillFootholds(motion, static_cast<int>(model.feet.size()), plan);
  return plan;
}

}  // namespace gaitwright::synthetic
