// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/dynamics/dynamics.h"
#include "planning/plan/motion_plan.h"

namespace gaitwright {

/// One foot stands, swings from 0.1 s to 0.235 s, and stands until 0.4 s; all others stand.
inline MotionPlan SteppingPlan(const RobotModel& model) {
  MotionPlan plan;
  plan.whole_body.step_s = 0.005;
  plan.whole_body.q.assign(81, StandingConfiguration(model));
  plan.whole_body.v.assign(81, VectorX::Zero(model.nv()));
  plan.whole_body.a = plan.whole_body.v;
  plan.terrain.patches.emplace_back();
  std::vector<std::vector<ContactInterval>> stays(model.feet.size(), {{0.0, 0.4}});
  stays[0] = {{0.0, 0.1}, {0.235, 0.4}};
  plan.schedule = ScheduleFromIntervals(stays, 0.0, 0.4);
  for (int foot = 0; foot < static_cast<int>(model.feet.size()); ++foot) {
    for (const ContactInterval& stay : stays[static_cast<std::size_t>(foot)])
      plan.footsteps.footholds.push_back({foot, Pose::Identity(), Vector3::Zero(), 0, stay.start_s, stay.end_s});
  }
  plan.footsteps.footholds[1].X_WF.translation().x() = 0.1;
  SwingTrajectory swing;
  swing.start_s = 0.1;
  swing.end_s = 0.235;
  swing.X_WF_end = plan.footsteps.footholds[1].X_WF;
  swing.lift_m = 0.05;
  plan.swings.push_back(swing);
  return plan;
}

}  // namespace gaitwright
