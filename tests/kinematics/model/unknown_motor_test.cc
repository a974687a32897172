// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/unknown_motor.h"

#include <gtest/gtest.h>

#include <cmath>

#include "kinematics/model/load_robot.h"

namespace gaitwright {
namespace {

TEST(BoundsOfUnknownMotor, AreBeyondEveryMotorThatIsKnown) {
  int known = 0;
  for (const std::string& name : RobotNames()) {
    const RobotModel model = LoadNamedRobot(name).value();
    for (int dof = 0; dof < model.num_dofs(); ++dof) {
      const MotorBounds bounds = BoundsOfUnknownMotor(model, dof);
      const double effort = model.dof_effort_limit(dof), speed = model.dof_velocity_limit(dof);
      if (!std::isfinite(effort) || !std::isfinite(speed)) continue;
      EXPECT_GT(bounds.effort, 2.0 * effort) << name << " " << dof;
      EXPECT_GT(bounds.speed, 1.5 * speed) << name << " " << dof;
      ++known;
    }
  }
  EXPECT_GT(known, 70);
}

TEST(BoundsOfUnknownMotor, GoByMassAndLegLength) {
  const RobotModel humanoid = LoadNamedRobot("humanoid").value();
  EXPECT_NEAR(BoundsOfUnknownMotor(humanoid, 0).effort, 2.0 * 45.0 * kGravity * humanoid.leg_length_m(), 0.01);
  EXPECT_NEAR(BoundsOfUnknownMotor(humanoid, 0).speed, 20.0 * std::sqrt(kGravity / humanoid.leg_length_m()), 1e-9);
}

}  // namespace
}  // namespace gaitwright
