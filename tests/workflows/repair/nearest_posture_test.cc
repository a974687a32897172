// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "kinematics/dynamics/foot_contact.h"
#include "tests/workflows/repair/standing_motion.h"
#include "workflows/repair/nearest_posture_internal.h"

namespace gaitwright {
namespace {

std::vector<Pose> FeetAt(const RobotModel& model, const VectorX& q) {
  DynamicsScratch scratch(model);
  ForwardKinematics(model, q, scratch);
  std::vector<Pose> X_WF;
  for (int f = 0; f < static_cast<int>(model.legs.size()); ++f) X_WF.push_back(ContactFrame(model, scratch, f));
  return X_WF;
}

TEST(NearestPosture, KeepsAPostureWhoseFeetAreInPlace) {
  for (const char* name : {"a1", "nao", "h1"}) {
    const RobotModel& model = NamedRobot(name);
    const VectorX given = StandingConfiguration(model);
    VectorX q;
    EXPECT_LT(NearestPosture(model, {}).Solve(given, FeetAt(model, given), q), 1e-9);
    EXPECT_LT((q - given).lpNorm<Eigen::Infinity>(), 1e-4) << name;
  }
}

TEST(NearestPosture, MovesFeetToTheirPlacesAndTheBaseByLess) {
  for (const char* name : {"a1", "h1"}) {
    const RobotModel& model = NamedRobot(name);
    const VectorX given = StandingConfiguration(model);
    std::vector<Pose> X_WF = FeetAt(model, given);
    X_WF[0].translation() += Vector3(0.02, 0.0, 0.01);
    VectorX q;
    EXPECT_LT(NearestPosture(model, {}).Solve(given, X_WF, q), 1e-5) << name;
    EXPECT_GT((q - given).lpNorm<Eigen::Infinity>(), 1e-3) << name;
    EXPECT_LT((q - given).head<3>().norm(), 0.015) << name;
    EXPECT_LT((FeetAt(model, q)[1].translation() - X_WF[1].translation()).norm(), 1e-4) << name;
  }
}

TEST(NearestPosture, KeepsJointsInTheirRanges) {
  const RobotModel& model = NamedRobot("a1");
  const VectorX given = StandingConfiguration(model);
  std::vector<Pose> X_WF = FeetAt(model, given);
  for (Pose& X : X_WF) X.translation().x() += 1.0;  // out of reach
  VectorX q;
  NearestPosture(model, {.base_position = 1e3, .base_rotation = 1e3}).Solve(given, X_WF, q);
  for (int d = 0; d < model.num_dofs(); ++d) {
    EXPECT_GE(q[7 + d], model.dof_lower(d)) << model.dof_names[static_cast<std::size_t>(d)];
    EXPECT_LE(q[7 + d], model.dof_upper(d)) << model.dof_names[static_cast<std::size_t>(d)];
  }
}

}  // namespace
}  // namespace gaitwright
