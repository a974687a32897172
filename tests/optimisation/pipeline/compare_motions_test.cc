// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/pipeline/compare_motions.h"

#include <gtest/gtest.h>

#include <cmath>

#include "kinematics/model/load_robot.h"

namespace gaitwright {
namespace {

TEST(TorqueUseOf, IsTheRootOfTheMeanSquareOfShares) {
  const RobotModel model = *LoadNamedRobot("a1");
  WholeBodyTrajectory motion;
  VectorX limits(model.num_dofs());
  for (int d = 0; d < model.num_dofs(); ++d) limits[d] = model.dof_effort_limit(d);
  motion.tau = {0.3 * limits, -0.4 * limits};
  const TorqueUse use = TorqueUseOf(model, motion);
  EXPECT_NEAR(use.rms, std::sqrt(0.5 * (0.09 + 0.16)), 1e-12);
  EXPECT_NEAR(use.peak, 0.4, 1e-12);
  EXPECT_EQ(TorqueUseOf(model, {}).rms, 0.0);
}

TEST(IsBetterMotion, LimitsComeBeforeBalanceAndBalanceBeforeTorque) {
  constexpr double kResidual = 3e-4;
  const MotionFigures sound{0.0, 1e-4, {0.2, 0.8}}, less{0.0, 1e-4, {0.19, 0.8}}, hardly{0.0, 1e-4, {0.1995, 0.8}};
  const MotionFigures past{0.1, 1e-4, {0.1, 0.4}}, nearer{0.05, 1e-4, {0.3, 0.9}}, unbalanced{0.0, 0.04, {0.1, 0.4}};
  EXPECT_TRUE(IsBetterMotion(past, {}, kResidual)) << "any is better than none";
  EXPECT_TRUE(IsBetterMotion(less, sound, kResidual));
  EXPECT_FALSE(IsBetterMotion(hardly, sound, kResidual));
  EXPECT_FALSE(IsBetterMotion(sound, sound, kResidual));
  EXPECT_TRUE(IsBetterMotion(sound, past, kResidual));
  EXPECT_FALSE(IsBetterMotion(past, sound, kResidual));
  EXPECT_TRUE(IsBetterMotion(nearer, past, kResidual));
  EXPECT_TRUE(IsBetterMotion(sound, unbalanced, kResidual));
  EXPECT_FALSE(IsBetterMotion(unbalanced, sound, kResidual));
}

}  // namespace
}  // namespace gaitwright
