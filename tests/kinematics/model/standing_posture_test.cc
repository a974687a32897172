// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/standing_posture.h"

#include <limits>

#include "kinematics/model/body_tree.h"
#include "tests/kinematics/made_robots.h"
#include "tests/kinematics/model/small_urdf.h"
#include "tests/unusual_robots.h"

namespace gaitwright {
namespace {

VectorX NothingGiven(const RobotModel& model) {
  return VectorX::Constant(model.num_dofs(), std::numeric_limits<double>::quiet_NaN());
}

/// Poses of the feet in the base in the standing posture.
std::vector<Pose> StandingFeet(const RobotModel& model) {
  const std::vector<Pose> X_OB = BodyPoses(model, model.standing_joints);
  std::vector<Pose> X_OF;
  for (const Leg& leg : model.legs) {
    const Foot& foot = model.feet[static_cast<std::size_t>(leg.foot)];
    X_OF.push_back(X_OB[static_cast<std::size_t>(foot.body)] * foot.X_BF);
  }
  return X_OF;
}

class StandingPostureTest : public testing::TestWithParam<const char*> {};

TEST_P(StandingPostureTest, AllFeetAreLevelOnTheGroundAndJointsWithinTheirLimits) {
  const RobotModel model = AnyRobot(GetParam());
  const std::vector<Pose> X_OF = StandingFeet(model);
  for (std::size_t i = 0; i < X_OF.size(); ++i) {
    EXPECT_NEAR(X_OF[i].translation().z() - model.feet[i].radius, -model.standing_base_height_m, 2e-3) << i;
    EXPECT_NEAR(X_OF[i].linear()(2, 2), 1.0, 1e-4) << "z of the foot is up";
  }
  for (int d = 0; d < model.num_dofs(); ++d) {
    EXPECT_GE(model.standing_joints[d], model.dof_lower(d));
    EXPECT_LE(model.standing_joints[d], model.dof_upper(d));
  }
}

INSTANTIATE_TEST_SUITE_P(MadeRobots, StandingPostureTest, testing::Values("sliding", "hollow", "line"),
                         [](const auto& given) { return std::string(given.param); });

TEST(StandingPosture, TheCentreOfMassIsOverTheMiddleOfFeetWithoutSoles) {
  const RobotModel model = *LoadRobotFromText(unusual::Plain(), "");
  const std::vector<Pose> X_OB = BodyPoses(model, model.standing_joints);
  Vector3 centre = Vector3::Zero(), middle = Vector3::Zero();
  for (std::size_t b = 0; b < X_OB.size(); ++b)
    centre += model.bodies[b].mass / model.total_mass_kg * (X_OB[b] * model.bodies[b].p_BC);
  for (const Pose& X : StandingFeet(model)) middle += 0.25 * X.translation();
  EXPECT_LT((centre - middle).head<2>().norm(), 1e-5);
}

TEST(StandingPosture, KneesBendToTheSideOfTheirLimits) {
  const RobotModel model = *LoadRobotFromText(unusual::Plain(), "");
  for (const Leg& leg : model.legs) {
    const Joint& knee = model.joints[static_cast<std::size_t>(leg.knee_joint)];
    EXPECT_GT(model.standing_joints[knee.dof] * leg.knee_sign, 0.3) << leg.name;
  }
}

TEST(StandingPosture, LeftAndRightStandAsMirrorImages) {
  const RobotModel model = *LoadRobotFromText(unusual::Plain(), "");
  const std::vector<Pose> X_OF = StandingFeet(model);
  for (std::size_t i = 0; i < model.legs.size(); ++i) {
    const Vector3 a = X_OF[i].translation(), b = X_OF[static_cast<std::size_t>(model.legs[i].mirror)].translation();
    EXPECT_LT((a - Vector3(b.x(), -b.y(), b.z())).norm(), 1e-4) << i;
  }
}

TEST(StandingPosture, ALargerRobotStandsInTheSamePosture) {
  const RobotModel one = *LoadRobotFromText(unusual::Plain(), ""), two = *LoadRobotFromText(unusual::Plain(2.0), "");
  EXPECT_LT((one.standing_joints - two.standing_joints).norm(), 1e-3);
  EXPECT_NEAR(two.standing_base_height_m, 2.0 * one.standing_base_height_m, 1e-3);
  EXPECT_NEAR(two.nominal_speed_m_s, std::sqrt(2.0) * one.nominal_speed_m_s, 1e-6) << "Froude";
}

TEST(StandingPosture, DerivingItAgainGivesTheSame) {
  const RobotModel model = *LoadRobotFromText(FourLegs(), "");
  RobotModel again = model;
  DeriveStanding(again, NothingGiven(model));
  EXPECT_LT((again.standing_joints - model.standing_joints).norm(), 1e-6);
  EXPECT_NEAR(again.standing_base_height_m, model.standing_base_height_m, 1e-6);
}

TEST(StandingPosture, PositionsThatAreGivenAreKept) {
  RobotModel model = *LoadRobotFromText(FourLegs(), "");
  VectorX given = NothingGiven(model);
  given[model.DofIndex("A_hip")] = 0.3;
  given[model.DofIndex("A_knee")] = -0.6;
  DeriveStanding(model, given);
  EXPECT_EQ(model.standing_joints[model.DofIndex("A_hip")], 0.3);
  EXPECT_EQ(model.standing_joints[model.DofIndex("A_knee")], -0.6);
  double lowest = 0.0;
  for (const Pose& X : StandingFeet(model)) lowest = std::min(lowest, X.translation().z() - 0.02);
  EXPECT_NEAR(model.standing_base_height_m, -lowest, 1e-12) << "above the lowest foot";
}

}  // namespace
}  // namespace gaitwright
