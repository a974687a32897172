// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "kinematics/ik/leg_ik.h"
#include "kinematics/model/load_robot.h"

namespace gaitwright {
namespace {

/// A posture of a leg near its standing posture. @param i  number of the posture
VectorX NearStanding(const RobotModel& model, const LegIk& ik, int i) {
  VectorX q = model.standing_joints(ik.dofs());
  for (Eigen::Index k = 0; k < q.size(); ++k) q[k] += 0.1 * std::sin(1.3 * i + 2.1 * static_cast<double>(k));
  return q;
}

TEST(LegIkNear, TargetsCloseToTheGuessAreReached) {
  for (const auto& [name, method] : {std::pair("a1", LegIk::Method::kThreeJoint),
                                     {"nao", LegIk::Method::kSixJoint},
                                     {"a1", LegIk::Method::kDamped},
                                     {"nao", LegIk::Method::kDamped}}) {
    const RobotModel model = LoadNamedRobot(name).value();
    const LegIk ik(model, 0, method);
    for (int i = 0; i < 50; ++i) {
      const VectorX q = NearStanding(model, ik, i);
      const Pose X_BF = ik.FootPose(q);
      const std::optional<VectorX> found = ik.SolveNear(X_BF, NearStanding(model, ik, i + 1));
      ASSERT_TRUE(found) << name << " " << i;
      EXPECT_LT((ik.FootPose(*found).translation() - X_BF.translation()).norm(), 1e-9) << name << " " << i;
    }
  }
}

TEST(LegIkNear, NothingIsFoundOutOfReach) {
  for (const char* name : {"a1", "nao"}) {
    const RobotModel model = LoadNamedRobot(name).value();
    const LegIk ik(model, 0, LegIk::Method::kDamped);
    Pose far = ik.FootPose(NearStanding(model, ik, 0));
    far.translation() *= 4.0;
    EXPECT_FALSE(ik.SolveNear(far, NearStanding(model, ik, 0))) << name;
    EXPECT_THROW(ik.SolveNear(far, VectorX::Zero(1)), InvalidArgument);
  }
}

}  // namespace
}  // namespace gaitwright
