// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/centroidal/body_trajectory.h"

#include <gtest/gtest.h>

#include "tests/optimisation/centroidal/rigid_bodies.h"

namespace gaitwright {
namespace {

TEST(BodyTrajectory, AStraightPathStandsBeforeTheFirstLiftOffAndAfterTheLastTouchDown) {
  const RigidBodyProblem problem = rigid_bodies::Walker(0.6);  // off at 0.3 s, down at 1.45 s of 1.9 s
  const BodyTrajectory trajectory = StraightPath(FlatTerrain(), problem, 0.05);
  for (std::size_t k = 0; k < trajectory.time_s.size(); ++k) {
    EXPECT_NEAR(trajectory.p_WC[k].x(), 0.6 * std::clamp((trajectory.time_s[k] - 0.3) / 1.15, 0.0, 1.0), 1e-9);
    EXPECT_NEAR(trajectory.p_WC[k].z(), 0.65, 1e-9);
  }
  EXPECT_NEAR(trajectory.time_s.back(), 1.9, 1e-12);
}

TEST(BodyTrajectory, AStraightPathIsAtNominalHeightAboveTheGround) {
  RigidBodyProblem problem = rigid_bodies::Walker(1.0);
  problem.goal.p_WC.z() += 0.5;
  Terrain ramp;
  ramp.patches.push_back(
      PatchThrough("ramp", {{-2.0, -2.0, -1.0}, {4.0, -2.0, 2.0}, {4.0, 2.0, 2.0}, {-2.0, 2.0, -1.0}}, 0.8));
  const BodyTrajectory trajectory = StraightPath(ramp, problem, 0.1);
  for (const Vector3& p : trajectory.p_WC) EXPECT_NEAR(p.z(), 0.65 + 0.5 * p.x(), 1e-9);
}

TEST(BodyTrajectory, FittingBringsFeetWithinReach) {
  RigidBodyProblem problem = rigid_bodies::Walker(0.9);
  for (RigidStance& stance : problem.stances) {
    if (!stance.held) stance.X_WF.translation().x() += 0.2;
  }
  BodyTrajectory trajectory = StraightPath(FlatTerrain(), problem, 0.1);
  const double before = OutOfReach(problem, trajectory).largest_m;
  EXPECT_GT(before, 0.05);
  FitBodyTrajectory(problem, trajectory);
  EXPECT_LT(OutOfReach(problem, trajectory).largest_m, 0.01);
}

TEST(BodyTrajectory, ABodyPitchesWhereItsForeFeetStandHigherThanALevelOneReaches) {
  RigidBodyProblem problem = rigid_bodies::Trotter(0.0);
  for (RigidStance& stance : problem.stances) {
    if (stance.start_s > 0.4 && stance.start_s < 0.9 && stance.foot < 2) stance.X_WF.translation().z() += 0.2;
    if (stance.start_s > 0.4 && stance.start_s < 0.9)
      stance.region_F = {{-0.1, -0.1}, {0.1, -0.1}, {0.1, 0.1}, {-0.1, 0.1}};
  }
  BodyTrajectory trajectory = StraightPath(FlatTerrain(), problem, 0.05);
  EXPECT_GT(OutOfReach(problem, trajectory).largest_m, 0.1);
  FitBodyTrajectory(problem, trajectory);
  double nose_up = 0.0;
  for (const Vector3& angles : trajectory.angles_rad) nose_up = std::min(nose_up, angles.y());
  EXPECT_LT(nose_up, -0.1);  // right-hand rotation about y, which points left
  EXPECT_LT(OutOfReach(problem, trajectory).largest_m, 0.05);
}

TEST(BodyTrajectory, FittingKeepsFootholdsInTheirRegionsAndHeldOnesWhereTheyAre) {
  RigidBodyProblem problem = rigid_bodies::Walker(0.6);
  const Pose held = problem.stances[0].X_WF, tile = problem.stances[1].X_WF;
  problem.stances[1].region_F = {{-0.2, -0.02}, {-0.15, -0.02}, {-0.15, 0.02}, {-0.2, 0.02}};
  BodyTrajectory trajectory = StraightPath(FlatTerrain(), problem, 0.1);
  FitBodyTrajectory(problem, trajectory);
  EXPECT_TRUE(problem.stances[0].X_WF.isApprox(held));
  const Vector3 moved = tile.inverse() * problem.stances[1].X_WF.translation();
  EXPECT_GE(moved.x(), -0.2 - 1e-9);
  EXPECT_LE(moved.x(), -0.15 + 1e-9);
  EXPECT_NEAR(problem.stances[1].region_F[1].x() + moved.x(), -0.15, 1e-9);  // the region does not move
}

TEST(BodyTrajectory, OutOfReachIsTheFarthestBeyondAnySideAndItsStance) {
  RigidBodyProblem problem = rigid_bodies::Walker(0.0);
  BodyTrajectory trajectory = StraightPath(FlatTerrain(), problem, 0.1);
  EXPECT_EQ(OutOfReach(problem, trajectory).largest_m, 0.0);
  EXPECT_EQ(OutOfReach(problem, trajectory).stance, -1);
  problem.stances[3].X_WF.translation().x() += 0.25 + 0.07;
  const BodyTrajectoryMisfit misfit = OutOfReach(problem, trajectory);
  EXPECT_NEAR(misfit.largest_m, 0.07, 1e-9);
  EXPECT_EQ(misfit.stance, 3);
  EXPECT_GT(StanceMisfit(problem, trajectory, 3), StanceMisfit(problem, trajectory, 4));
}

}  // namespace
}  // namespace gaitwright
