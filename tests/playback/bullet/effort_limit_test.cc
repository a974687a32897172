// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "kinematics/model/load_robot.h"
#include "playback/bullet/bullet_world.h"

namespace gaitwright {
namespace {

/// Rate of the first joint after one step in the air under a feed-forward torque and no gains.
double RateAfter(const RobotModel& model, double torque) {
  VectorX q = StandingConfiguration(model);
  q[2] += 1.0;
  BulletWorld world(model, FlatTerrain(), q, {});
  world.SetState(q, VectorX::Zero(model.nv()));
  const VectorX zero = VectorX::Zero(model.num_dofs());
  JointCommand command{zero, zero, zero, zero, zero};
  command.tau_ff[0] = torque;
  world.Step(command);
  return world.v()[6];
}

TEST(EffortLimit, HoldsForFeedForwardWithoutGains) {
  const RobotModel a1 = LoadNamedRobot("a1").value();
  const double limit = a1.dof_effort_limit(0);
  EXPECT_GT(std::abs(RateAfter(a1, limit) - RateAfter(a1, 0.5 * limit)), 1e-3);
  EXPECT_NEAR(RateAfter(a1, 10.0 * limit), RateAfter(a1, limit), 1e-6);
}

}  // namespace
}  // namespace gaitwright
