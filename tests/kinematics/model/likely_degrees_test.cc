// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/likely_degrees.h"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

#include "kinematics/model/load_robot.h"

namespace gaitwright {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;

TEST(LikelyDegrees, AreThosePastTheLimitsThatWouldBeWithinThem) {
  const RobotModel model = LoadNamedRobot("a1").value();
  const VectorX standing = model.standing_joints;
  EXPECT_EQ(LikelyDegrees(model, {standing}), std::nullopt);
  int knee = 0;
  (kDegrees * standing).cwiseAbs().maxCoeff(&knee);
  const auto found = LikelyDegrees(model, {0.9 * kDegrees * standing, kDegrees * standing});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->row, 1);
  EXPECT_EQ(found->dof, knee);
  VectorX broken = kDegrees * standing;
  broken[0] = 500.0;
  EXPECT_EQ(LikelyDegrees(model, {broken}), std::nullopt) << "nor is it within its limits as degrees";
  EXPECT_EQ(LikelyDegrees(model, {kDegrees * standing, standing}), std::nullopt) << "nor are all of its rows";
  VectorX lacking = kDegrees * standing;
  lacking[0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(LikelyDegrees(model, {lacking}), (PastLimit{0, knee}));
}

TEST(LikelyDegrees, NeedMoreThanALittleBeyondALimit) {
  const RobotModel model = LoadNamedRobot("a1").value();
  VectorX joints = VectorX::Zero(model.num_dofs());
  for (int d = 0; d < model.num_dofs(); ++d) joints[d] = model.dof_upper(d);
  joints[0] = model.dof_upper(0) + 0.3;
  EXPECT_EQ(LikelyDegrees(model, {joints}), std::nullopt);
}

}  // namespace
}  // namespace gaitwright
