// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "kinematics/model/body_tree.h"
#include "kinematics/model/load_robot.h"
#include "tests/unusual_robots.h"

namespace gaitwright {
namespace {

TEST(StandingPosture, LegsOfDifferentLengthsStandOnOneLevel) {
  unusual::UrdfText urdf;
  urdf.Link("body", 8.0, 0.4, urdf.Block(0.4, 0.2, 0.1));
  for (const unusual::Hip& hip : unusual::Four())
    unusual::MammalLeg(urdf, hip, unusual::Abduction(), unusual::Knee(), hip.x > 0.0 ? 0.2 : 0.23);
  const RobotModel model = LoadRobotFromText(urdf.Done("longer_behind"), "").value();
  ASSERT_EQ(model.feet.size(), 4U);
  EXPECT_GT(std::abs(model.legs.front().length_m - model.legs.back().length_m), 0.02);
  const std::vector<Pose> X_OB = BodyPoses(model, model.standing_joints);
  for (const Foot& foot : model.feet) {
    const double bottom = (X_OB[static_cast<std::size_t>(foot.body)] * foot.X_BF).translation().z() - foot.radius;
    EXPECT_NEAR(bottom, -model.standing_base_height_m, 1e-6) << foot.name;
  }
}

}  // namespace
}  // namespace gaitwright
