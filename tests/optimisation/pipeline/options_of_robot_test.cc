// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "kinematics/model/load_robot.h"
#include "optimisation/pipeline/options_of_robot_internal.h"
#include "tests/unusual_robots.h"

namespace gaitwright {
namespace {

TEST(OptionsOf, RobotsThatCannotStandAreRigidBodiesOnBothFeetForAMoment) {
  MotionOptions asked;
  asked.footsteps.initial_stand_s = 2.0;
  const MotionOptions of_points = OptionsOf(LoadRobotFromText(unusual::PointBiped(), "").value(), asked);
  EXPECT_EQ(of_points.centre_of_mass.method, "rigid-body");
  EXPECT_EQ(of_points.footsteps.initial_stand_s, 0.1);
  EXPECT_EQ(of_points.footsteps.final_stand_s, 0.1);
  MotionOptions of_nao = OptionsOf(LoadNamedRobot("nao").value(), asked);
  EXPECT_EQ(TextsOf(of_nao.Fields()), TextsOf(asked.Fields()));
}

}  // namespace
}  // namespace gaitwright
