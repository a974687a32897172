// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/rigid_body_robot.h"

#include <gtest/gtest.h>

#include <cmath>

#include "kinematics/dynamics/dynamics.h"

namespace gaitwright {
namespace {

/// Two feet beside a body: a point, and a sole of four corners.
RigidBodyProblem TwoFootedProblem() {
  RigidBodyProblem problem;
  problem.mass_kg = 12.0;
  problem.inertia_B = Vector3(0.3, 0.4, 0.5).asDiagonal();
  for (const double side : {1.0, -1.0}) {
    RigidFoot foot;
    foot.p_CF_nominal_B = Vector3(0.05, 0.2 * side, -0.6);
    foot.workspace_B = BoxAbout(foot.p_CF_nominal_B, Vector3(0.15, 0.1, 0.2));
    foot.force_max_n = 300.0;
    problem.feet.push_back(foot);
  }
  problem.feet[1].contacts_F = {{0.1, -0.05, 0.0}, {0.1, 0.05, 0.0}, {-0.1, 0.05, 0.0}, {-0.1, -0.05, 0.0}};
  for (const int foot : {0, 1}) {
    RigidStance stance;
    stance.foot = foot;
    stance.end_s = 1.0;
    stance.friction = foot == 0 ? 0.5 : 0.75;
    problem.stances.push_back(stance);
  }
  return problem;
}

RobotModel RobotOf(const RigidBodyProblem& problem) {
  const Result<RobotModel> robot = RigidBodyRobot(problem, "brick");
  EXPECT_TRUE(robot.ok()) << robot.failure().message;
  return robot.ok() ? *robot : RobotModel{};
}

int DofNamed(const RobotModel& robot, const std::string& name) {
  for (int d = 0; d < robot.num_dofs(); ++d) {
    if (robot.dof_names[static_cast<std::size_t>(d)] == name) return d;
  }
  ADD_FAILURE() << name;
  return 0;
}

TEST(RigidBodyRobot, HasTheMassAndTheCentreOfMassOfTheBody) {
  const RigidBodyProblem problem = TwoFootedProblem();
  const RobotModel robot = RobotOf(problem);
  ASSERT_FALSE(robot.bodies.empty());
  EXPECT_NEAR(robot.total_mass_kg, 12.0, 1e-9);
  DynamicsScratch scratch(robot);
  VectorX q = StandingConfiguration(robot);
  ForwardKinematics(robot, q, scratch);
  EXPECT_LT((CentreOfMass(robot, scratch) - q.head<3>()).norm(), 1e-6) << "the trunk's origin";
}

/// Joint positions are the offset of the foot from its nominal position, in the trunk's axes.
TEST(RigidBodyRobot, SlidesMoveAFootFromItsNominalPlaceAlongTheBodysAxes) {
  const RigidBodyProblem problem = TwoFootedProblem();
  const RobotModel robot = RobotOf(problem);
  const std::vector<int> of_problem = ProblemFeetOf(robot, problem);
  ASSERT_EQ(of_problem.size(), 2U);
  DynamicsScratch scratch(robot);
  VectorX q = VectorX::Zero(robot.nq());
  q[6] = 1.0;
  const Vector3 offset(0.03, -0.02, 0.07);
  for (int axis = 0; axis < 3; ++axis) q[7 + DofNamed(robot, std::string("foot_1_") + "xyz"[axis])] = offset[axis];
  ForwardKinematics(robot, q, scratch);
  for (std::size_t f = 0; f < robot.feet.size(); ++f) {
    const Foot& foot = robot.feet[f];
    Vector3 expected = problem.feet[static_cast<std::size_t>(of_problem[f])].p_CF_nominal_B;
    if (of_problem[f] == 1) expected += offset;
    EXPECT_LT((FramePose(scratch, foot.body, foot.X_BF).translation() - expected).norm(), 1e-9) << foot.link;
  }
}

TEST(RigidBodyRobot, LimitsOfTheSlidesAreTheWorkspace) {
  const RobotModel robot = RobotOf(TwoFootedProblem());
  const std::vector<double> half = {0.15, 0.1, 0.2};
  for (int axis = 0; axis < 3; ++axis) {
    const int d = DofNamed(robot, std::string("foot_0_") + "xyz"[axis]);
    EXPECT_NEAR(robot.dof_lower(d), -half[static_cast<std::size_t>(axis)], 1e-9);
    EXPECT_NEAR(robot.dof_upper(d), half[static_cast<std::size_t>(axis)], 1e-9);
  }
}

/// The largest force of a friction cone: the normal force at every point, plus friction.
TEST(RigidBodyRobot, EffortsAreTheLargestForcesOfTheCones) {
  const RobotModel robot = RobotOf(TwoFootedProblem());
  EXPECT_NEAR(robot.dof_effort_limit(DofNamed(robot, "foot_0_z")), 300.0 * std::hypot(1.0, 0.5), 1e-6);
  EXPECT_NEAR(robot.dof_effort_limit(DofNamed(robot, "foot_1_x")), 4.0 * 300.0 * 1.25, 1e-6);
}

TEST(RigidBodyRobot, APointHasThreeJointsAndASoleTurnsToo) {
  const RobotModel robot = RobotOf(TwoFootedProblem());
  EXPECT_EQ(robot.num_dofs(), 3 + 6);
  for (const Foot& foot : robot.feet) EXPECT_EQ(foot.has_sole(), foot.link == "foot_1");
}

TEST(RigidBodyRobot, FeetOfAnotherRobotAreRefused) {
  const RigidBodyProblem problem = TwoFootedProblem();
  RobotModel robot = RobotOf(problem);
  robot.feet[0].link = "hoof";
  EXPECT_THROW(ProblemFeetOf(robot, problem), InvalidArgument);
  robot.feet.pop_back();
  EXPECT_THROW(ProblemFeetOf(robot, problem), InvalidArgument);
}

TEST(RigidBodyRobot, ABoxIsFoundWhateverTheLengthOfItsNormals) {
  const Vector3 centre(0.1, -0.2, -0.5), half(0.2, 0.3, 0.1);
  std::vector<WorkspaceSide> sides = BoxAbout(centre, half);
  for (std::size_t i = 0; i < sides.size(); ++i) {
    sides[i].normal *= 1.0 + static_cast<double>(i);
    sides[i].offset *= 1.0 + static_cast<double>(i);
  }
  const auto [low, high] = BoxOf(sides);
  EXPECT_LT((low - (centre - half)).norm(), 1e-12);
  EXPECT_LT((high - (centre + half)).norm(), 1e-12);
}

TEST(RigidBodyRobot, WorkspacesThatAreNoBoxesAndFeetOfTwoPointsAreRefused) {
  std::vector<WorkspaceSide> sides = BoxAbout(Vector3::Zero(), Vector3::Ones());
  std::vector<WorkspaceSide> open(sides.begin() + 1, sides.end());
  EXPECT_THROW(BoxOf(open), InvalidArgument);
  sides[0].normal = Vector3(1.0, 1.0, 0.0);
  EXPECT_THROW(BoxOf(sides), InvalidArgument);
  RigidBodyProblem problem = TwoFootedProblem();
  problem.feet[1].contacts_F.resize(2);
  EXPECT_THROW(RigidBodyTextsOf(problem, "brick"), InvalidArgument);
  problem = TwoFootedProblem();
  problem.feet[1].contacts_F[2].z() = 0.01;
  EXPECT_THROW(RigidBodyTextsOf(problem, "brick"), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
