// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "playback/bullet/condensed_solver_internal.h"
#include "playback/bullet/joint_rows_internal.h"
#include "tests/kinematics/made_robots.h"
#include "tests/playback/bullet/small_world.h"

namespace gaitwright::bullet {
namespace {

/// A gear that is given twice adds no constraint: the impulses of the two are not unique, but the motion is.
TEST(CondensedSolver, GearsThatDependOnEachOtherAreHeldStill) {
  const RobotModel model = AnyRobot("mimic");
  const Gear of = FirstGear(model);
  VectorX q = StandingConfiguration(model);
  q[2] += 50.0;
  const auto rate_after = [&](int gears) {
    SmallWorld<CondensedSolver> made(model, FlatTerrain(), q);
    std::vector<std::unique_ptr<GearRow>> rows;
    for (int k = 0; k < gears; ++k) {
      rows.push_back(std::make_unique<GearRow>(made.body, of.joint, of.follower, of.leader));
      made.world.addMultiBodyConstraint(rows.back().get());
    }
    for (int k = 0; k < 100; ++k) {
      made.body.multibody().addJointTorque(of.leader, 0.01);
      made.world.stepSimulation(0.001, 0);
      for (const auto& row : rows) EXPECT_LT(std::abs(row->Error()), 1e-6);
    }
    return made.body.multibody().getJointVel(of.leader);
  };
  const double free = rate_after(0), geared = rate_after(1);
  EXPECT_GT(std::abs(free - geared), 1e-3 * std::abs(free));
  EXPECT_NEAR(rate_after(2), geared, 1e-6 * std::abs(geared));
}

}  // namespace
}  // namespace gaitwright::bullet
