// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tests/workflows/repair/standing_motion.h"
#include "workflows/repair/stuck_joints_internal.h"

namespace gaitwright {
namespace {

/// A1 with dry friction that takes a share of the effort of its first joint, which sways.
struct Sticky {
  explicit Sticky(double share, double sway_rad) : model(NamedRobot("a1")), motion(synthetic::Standing(model, 101)) {
    model.joints[0].friction = share * model.joints[0].effort_limit;
    place = model.standing_joints[0];
    for (int k = 0; k < motion.size(); ++k) motion.q[static_cast<std::size_t>(k)][7] += sway_rad * std::sin(0.3 * k);
  }
  RobotModel model;
  EvenMotion motion;
  double place = 0.0;
};

TEST(StuckJoints, AJointThatFrictionHoldsStaysStill) {
  Sticky sticky(1.0, 0.3);
  const VectorX before = sticky.motion.q[10];
  const std::vector<HeldJoint> held = HoldStuckJoints(sticky.model, sticky.motion);
  ASSERT_EQ(held.size(), 1U);
  EXPECT_EQ(held[0].dof, 0);
  EXPECT_NEAR(held[0].moved, 0.3, 0.05);
  EXPECT_EQ(held[0].friction, held[0].limit);
  for (const VectorX& q : sticky.motion.q) EXPECT_EQ(q[7], sticky.motion.q[0][7]);
  EXPECT_NEAR(sticky.motion.q[0][7], sticky.place, 0.05);
  EXPECT_EQ(sticky.motion.q[10].tail(sticky.model.num_dofs() - 1), before.tail(sticky.model.num_dofs() - 1));
}

TEST(StuckJoints, WithLessFrictionOnlyNoiseIsHeld) {
  Sticky noise(0.7, 0.02), moves(0.7, 0.3), free(0.3, 0.02);
  EXPECT_EQ(HoldStuckJoints(noise.model, noise.motion).size(), 1U);
  EXPECT_TRUE(HoldStuckJoints(moves.model, moves.motion).empty());
  EXPECT_TRUE(HoldStuckJoints(free.model, free.motion).empty());
}

TEST(StuckJoints, WhatIsStillIsNotAChange) {
  Sticky still(1.0, 0.0);
  EXPECT_TRUE(HoldStuckJoints(still.model, still.motion).empty());
}

}  // namespace
}  // namespace gaitwright
