// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/pipeline/plan_posture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/spatial/rotation.h"
#include "optimisation/pipeline/robot_body.h"
#include "tests/named_robot.h"

namespace gaitwright {
namespace {

PostureKey PostureAt(const RobotModel& model, double after_s, const Vector3& shift,
                     const Vector3& turn_rad = Vector3::Zero()) {
  PostureKey key;
  key.after_s = after_s;
  key.shift = shift;
  key.turn_rad = turn_rad;
  key.joints = model.standing_joints;
  return key;
}

/// Down by 20 mm and to the left by 5 mm within 0.2 s.
PostureMotion ShortSquat(const RobotModel& model) {
  return {"squat", {PostureAt(model, 0.0, Vector3::Zero()), PostureAt(model, 0.2, {0.0, 0.005, -0.02})}};
}

MotionOptions OnCoarseGrid() {
  MotionOptions options;
  options.pipeline.grid_step_s = 0.01;
  return options;
}

Vector3 CentreOfMassAt(const RobotModel& model, const VectorX& q) {
  DynamicsScratch scratch(model);
  ForwardKinematics(model, q, scratch);
  return CentreOfMass(model, scratch);
}

class PlanPostureTest : public testing::TestWithParam<const char*> {};

TEST_P(PlanPostureTest, TheBodyGoesFromKeyToKeyOverFeetThatStay) {
  const RobotModel& model = NamedRobot(GetParam());
  const Result<MotionPlan> plan = PlanPosture(model, ShortSquat(model), OnCoarseGrid());
  ASSERT_TRUE(plan.ok()) << plan.failure().message;
  const WholeBodyTrajectory& w = plan->whole_body;
  ASSERT_EQ(w.size(), 21);
  const Vector3 standing = StandingCentreOfMass(model);
  EXPECT_LT((CentreOfMassAt(model, w.q.front()) - standing).norm(), 1e-6);
  EXPECT_LT((CentreOfMassAt(model, w.q[10]) - standing - Vector3(0.0, 0.0025, -0.01)).norm(), 1e-6) << "half way";
  EXPECT_LT((CentreOfMassAt(model, w.q.back()) - standing - Vector3(0.0, 0.005, -0.02)).norm(), 1e-6);
  for (const std::size_t end : {0U, 20U}) EXPECT_LT(w.v[end].norm(), 1e-8) << "at rest";
  ASSERT_EQ(plan->footsteps.footholds.size(), model.legs.size());
  DynamicsScratch scratch(model);
  for (const VectorX& q : w.q) {
    ForwardKinematics(model, q, scratch);
    for (std::size_t f = 0; f < model.legs.size(); ++f)
      EXPECT_NEAR(ContactFrame(model, scratch, static_cast<int>(f)).translation().z(), 0.0, 1e-6);
  }
}

TEST_P(PlanPostureTest, IsOnePartOfStandingStillWithItsName) {
  const RobotModel& model = NamedRobot(GetParam());
  const Result<MotionPlan> plan = PlanPosture(model, ShortSquat(model), OnCoarseGrid());
  ASSERT_TRUE(plan.ok()) << plan.failure().message;
  ASSERT_EQ(plan->parts.size(), 1U);
  EXPECT_EQ(plan->parts[0].gait.name, "squat");
  EXPECT_TRUE(StandsStill(plan->parts[0].gait));
  EXPECT_NEAR(plan->parts[0].end_s, 0.2, 1e-12);
  EXPECT_EQ(plan->provenance.made_by, "PlanPosture");
  EXPECT_EQ(plan->provenance.options.front(), (std::pair<std::string, std::string>("posture.name", "squat")));
  EXPECT_EQ(plan->robot_hash, model.hash);
  EXPECT_TRUE(plan->gates.empty());
  EXPECT_TRUE(plan->swings.empty());
  ASSERT_EQ(plan->schedule.phases.size(), 1U);
  EXPECT_EQ(plan->schedule.phases[0].stance, AllFeet(static_cast<int>(model.legs.size())));
}

TEST_P(PlanPostureTest, TheReferenceOfTheZmpIsThatOfTheMultibody) {
  const RobotModel& model = NamedRobot(GetParam());
  PostureMotion still = ShortSquat(model);
  still.keys[1].shift.setZero();
  const Result<MotionPlan> plan = PlanPosture(model, still, OnCoarseGrid());
  ASSERT_TRUE(plan.ok()) << plan.failure().message;
  ASSERT_EQ(plan->centroidal.p_WZ.size(), 21U);
  for (const Vector2& p : plan->centroidal.p_WZ) EXPECT_LT((p - StandingCentreOfMass(model).head<2>()).norm(), 1e-6);
  EXPECT_NEAR(plan->centroidal.omega_rad_s, std::sqrt(kGravity / StandingCentreOfMass(model).z()), 1e-9);
}

TEST_P(PlanPostureTest, AHeightThatIsAskedForReplacesThatOfStanding) {
  const RobotModel& model = NamedRobot(GetParam());
  MotionOptions options = OnCoarseGrid();
  options.pipeline.com_height_m = 0.95 * StandingCentreOfMass(model).z();
  const Result<MotionPlan> plan = PlanPosture(model, ShortSquat(model), options);
  ASSERT_TRUE(plan.ok()) << plan.failure().message;
  EXPECT_NEAR(CentreOfMassAt(model, plan->whole_body.q.front()).z(), options.pipeline.com_height_m, 1e-6);
}

TEST_P(PlanPostureTest, AKeyOutOfReachIsRefusedWithItsTime) {
  const RobotModel& model = NamedRobot(GetParam());
  PostureMotion leap = ShortSquat(model);
  leap.keys[1].shift.z() = 2.0 * model.leg_length_m();
  const Result<MotionPlan> plan = PlanPosture(model, leap, OnCoarseGrid());
  ASSERT_FALSE(plan.ok());
  EXPECT_EQ(plan.failure().kind, FailureKind::kInfeasible);
  EXPECT_EQ(plan.failure().code, FailureCode::kOutOfReach);
  EXPECT_TRUE(plan.failure().message.starts_with("at 0.")) << plan.failure().message;
}

TEST_P(PlanPostureTest, RefusesAMotionWithoutDurationOrKeys) {
  const RobotModel& model = NamedRobot(GetParam());
  PostureMotion none = ShortSquat(model);
  none.keys[1].after_s = 0.0;
  EXPECT_THROW((void)PlanPosture(model, none, OnCoarseGrid()), InvalidArgument);
  none.keys.resize(1);
  EXPECT_THROW((void)PlanPosture(model, none, OnCoarseGrid()), InvalidArgument);
}

INSTANTIATE_TEST_SUITE_P(Robots, PlanPostureTest, testing::Values("a1", "nao"));

TEST(PlanPosture, SectionsBecomePartsAndThoseThatWaitHaveAGate) {
  const RobotModel& model = NamedRobot("nao");
  PostureMotion motion = ShortSquat(model);
  motion.keys.push_back(PostureAt(model, 0.1, Vector3::Zero()));
  motion.sections = {{"down", 1, true}, {"up", 2, false}};
  const Result<MotionPlan> plan = PlanPosture(model, motion, OnCoarseGrid());
  ASSERT_TRUE(plan.ok()) << plan.failure().message;
  ASSERT_EQ(plan->parts.size(), 2U);
  EXPECT_EQ(plan->parts[0].gait.name, "down");
  EXPECT_EQ(plan->parts[1].gait.name, "up");
  EXPECT_NEAR(plan->parts[0].end_s, 0.2, 1e-12);
  EXPECT_EQ(plan->parts[1].start_s, plan->parts[0].end_s);
  EXPECT_NEAR(plan->parts[1].end_s - plan->parts[1].start_s, 0.1, 1e-12);
  EXPECT_EQ(plan->parts[1].command.extent, WalkCommand::Extent::kGoal) << "the body comes back to the right";
  EXPECT_LT(plan->parts[1].command.goal_y_m, -0.002);
  ASSERT_EQ(plan->gates.size(), 1U);
  EXPECT_NEAR(plan->gates[0].at_s, 0.2, 1e-12);
  EXPECT_EQ(plan->gates[0].phase, "down");
  EXPECT_EQ(plan->gates[0].contact, AllFeet(2));
}

TEST(PlanPosture, ALiftedFootLeavesTheGroundAndComesBackToItsPlace) {
  const RobotModel& model = NamedRobot("a1");
  PostureMotion motion{"lift",
                       {PostureAt(model, 0.0, Vector3::Zero()), PostureAt(model, 0.1, Vector3::Zero()),
                        PostureAt(model, 0.2, Vector3::Zero()), PostureAt(model, 0.1, Vector3::Zero())}};
  motion.lifts = {{0, 1, 2, 0.03}};
  const Result<MotionPlan> plan = PlanPosture(model, motion, OnCoarseGrid());
  ASSERT_TRUE(plan.ok()) << plan.failure().message;
  ASSERT_EQ(plan->swings.size(), 1U);
  EXPECT_EQ(plan->swings[0].foot, 0);
  EXPECT_NEAR(plan->swings[0].start_s, 0.1, 1e-12);
  EXPECT_NEAR(plan->swings[0].end_s, 0.3, 1e-12);
  ASSERT_EQ(plan->schedule.phases.size(), 3U);
  EXPECT_EQ(plan->schedule.phases[1].stance, AllFeet(4) & ~FootBit(0));
  EXPECT_EQ(plan->footsteps.footholds.size(), 5U);
  DynamicsScratch scratch(model);
  const auto height = [&](std::size_t row) {
    ForwardKinematics(model, plan->whole_body.q[row], scratch);
    return ContactFrame(model, scratch, 0).translation().z();
  };
  EXPECT_NEAR(height(20), 0.03, 1e-6);
  EXPECT_NEAR(height(5), 0.0, 1e-6);
  EXPECT_NEAR(height(35), 0.0, 1e-6);
  const Gait& gait = plan->parts[0].gait;
  EXPECT_NEAR(gait.cycle_s, 0.4, 1e-12);
  EXPECT_NEAR(gait.duty_factor[0], 0.5, 1e-12);
  EXPECT_NEAR(gait.phase[0], 0.75, 1e-12);
  EXPECT_EQ(gait.duty_factor[1], 1.0);
}

TEST(PlanPosture, TheBaseTurnsByRollPitchAndYaw) {
  const RobotModel& model = NamedRobot("a1");
  PostureMotion motion = ShortSquat(model);
  motion.keys[1].turn_rad = {0.05, -0.08, 0.1};
  const Result<MotionPlan> plan = PlanPosture(model, motion, OnCoarseGrid());
  ASSERT_TRUE(plan.ok()) << plan.failure().message;
  const Matrix3 turned =
      BaseRotation(plan->whole_body.q.back()) * BaseRotation(StandingConfiguration(model)).transpose();
  const Matrix3 expected = (Eigen::AngleAxisd(0.1, Vector3::UnitZ()) * Eigen::AngleAxisd(-0.08, Vector3::UnitY()) *
                            Eigen::AngleAxisd(0.05, Vector3::UnitX()))
                               .toRotationMatrix();
  EXPECT_LT(RotationLog(expected.transpose() * turned).norm(), 1e-8);
}

/// The head turns by 0.3 rad within 0.1 s.
PostureMotion TurnedHead(const RobotModel& model) {
  PostureMotion gesture{"look", {PostureAt(model, 0.0, Vector3::Zero()), PostureAt(model, 0.1, {0.0, 0.0, -9.0})}};
  gesture.keys[1].joints[model.DofIndex("HeadYaw")] += 0.3;
  return gesture;
}

TEST(WithGesture, MovesJointsOutsideTheLegsFromItsTimeOnAndNothingElse) {
  const RobotModel& model = NamedRobot("nao");
  const Result<MotionPlan> plan = PlanPosture(model, ShortSquat(model), OnCoarseGrid());
  ASSERT_TRUE(plan.ok()) << plan.failure().message;
  const Result<MotionPlan> moved = WithGesture(model, *plan, TurnedHead(model), 0.05, {});
  ASSERT_TRUE(moved.ok()) << moved.failure().message;
  const Eigen::Index head = 7 + model.DofIndex("HeadYaw");
  const double start = plan->whole_body.q[0][head];
  ASSERT_EQ(moved->whole_body.size(), plan->whole_body.size());
  const auto yaw = [&](std::size_t row) { return moved->whole_body.q[row][head] - start; };
  EXPECT_NEAR(yaw(5), 0.0, 1e-9);
  EXPECT_NEAR(yaw(10), 0.15, 1e-9);
  EXPECT_NEAR(yaw(15), 0.3, 1e-9);
  EXPECT_NEAR(yaw(20), 0.3, 1e-9);
  const auto& before = plan->centroidal.p_WC;
  for (const std::size_t row : {0U, 10U, 20U})
    EXPECT_LT((CentreOfMassAt(model, moved->whole_body.q[row]) - before[row]).norm(), 1e-6) << "shifts are ignored";
  EXPECT_EQ(moved->parts.size(), plan->parts.size());
}

TEST(WithGesture, RefusesOneThatDoesNotEndWithinThePlan) {
  const RobotModel& model = NamedRobot("nao");
  const Result<MotionPlan> plan = PlanPosture(model, ShortSquat(model), OnCoarseGrid());
  ASSERT_TRUE(plan.ok()) << plan.failure().message;
  EXPECT_TRUE(WithGesture(model, *plan, TurnedHead(model), 0.1, {}).ok());
  EXPECT_THROW((void)WithGesture(model, *plan, TurnedHead(model), 0.11, {}), InvalidArgument);
  EXPECT_THROW((void)WithGesture(model, *plan, TurnedHead(model), -0.01, {}), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
