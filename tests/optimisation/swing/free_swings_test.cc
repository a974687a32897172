// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/swing/free_swings.h"

#include <gtest/gtest.h>

#include <cmath>

#include "kinematics/trajectory/swing_curve.h"
#include "planning/plan/sample_plan.h"

namespace gaitwright {
namespace {

/// Two feet that stand, swing by 0.3 m one after the other, and stand again.
RigidBodyProblem TwoStepProblem() {
  RigidBodyProblem problem;
  problem.feet.resize(2);
  problem.duration_s = 2.0;
  const auto stance = [&](int foot, double start_s, double end_s, double x_m) {
    RigidStance of;
    of.foot = foot;
    of.start_s = start_s;
    of.end_s = end_s;
    of.X_WF.translation() = Vector3(x_m, foot == 0 ? 0.1 : -0.1, 0.0);
    problem.stances.push_back(of);
  };
  stance(0, 0.0, 0.4, 0.0);
  stance(1, 0.0, 1.1, 0.0);
  stance(0, 0.9, 2.0, 0.3);
  stance(1, 1.6, 2.0, 0.3);
  return problem;
}

std::vector<SwingTrajectory> OneSwing(int foot, double start_s, double end_s, double lift_m) {
  SwingTrajectory swing;
  swing.foot = foot;
  swing.start_s = start_s;
  swing.end_s = end_s;
  swing.X_WF_end.translation().x() = 0.3;
  swing.lift_m = lift_m;
  return {swing};
}

TEST(FreeSwings, AreBetweenTheStancesOfTheirFoot) {
  const RigidBodyProblem problem = TwoStepProblem();
  const std::vector<RigidSwing> left = FreeSwingsOf(FlatTerrain(), problem, OneSwing(0, 0.4, 0.9, 0.05), {0, 1}),
                                right = FreeSwingsOf(FlatTerrain(), problem, OneSwing(0, 1.1, 1.6, 0.05), {1, 0});
  ASSERT_EQ(left.size(), 1U);
  EXPECT_EQ(left[0].from, 0U);
  EXPECT_EQ(left[0].to, 2U);
  ASSERT_EQ(right.size(), 1U) << "the robot's first foot is the problem's second";
  EXPECT_EQ(right[0].from, 1U);
  EXPECT_EQ(right[0].to, 3U);
  EXPECT_TRUE(left[0].free);
  EXPECT_TRUE(FreeSwingsOf(FlatTerrain(), problem, OneSwing(0, 1.95, 2.5, 0.05), {0, 1}).empty())
      << "no stance comes after it";
}

/// The detour approximates the bump as closely as a spline with eight control points can.
TEST(FreeSwings, TheirDetourIsTheLiftOfTheCurve) {
  const std::vector<SwingTrajectory> swings = OneSwing(0, 0.4, 0.9, 0.08);
  const RigidSwing swing = FreeSwingsOf(FlatTerrain(), TwoStepProblem(), swings, {0, 1}).at(0);
  ASSERT_EQ(swing.detour_W.size(), 8U);
  const SwingCurve bump = CurveOf(swings[0]);
  SwingCurve spline = bump;
  spline.lift_m = 0.0;
  spline.detour_W = swing.detour_W;
  for (int k = 0; k <= 20; ++k) {
    const double time_s = 0.4 + 0.5 * k / 20.0;
    EXPECT_LT((Evaluate(bump, time_s).X_WF.translation() - Evaluate(spline, time_s).X_WF.translation()).norm(), 1e-3)
        << time_s;
  }
}

TEST(FreeSwings, PlanesOfTheGroundAreBelowTheSwing) {
  const std::vector<SwingTrajectory> swings = OneSwing(0, 0.4, 0.9, 0.08);
  const RigidSwing swing = FreeSwingsOf(FlatTerrain(), TwoStepProblem(), swings, {0, 1}).at(0);
  ASSERT_FALSE(swing.planes.empty());
  for (const SwingPlane& plane : swing.planes) {
    EXPECT_GT(plane.share, 0.0);
    EXPECT_LT(plane.share, 1.0);
    EXPECT_NEAR(plane.normal_W.norm(), 1.0, 1e-9);
    EXPECT_GT(plane.normal_W.z(), 0.5) << "the ground is below";
  }
  EXPECT_TRUE(FreeSwingsOf(Terrain{}, TwoStepProblem(), swings, {0, 1}).at(0).planes.empty());
}

/// Planes keep the contact point of a sphere so far off that the sphere is beyond them.
TEST(FreeSwings, ASphereKeepsFartherFromSidesThanAPoint) {
  const Terrain block{
      "block", {PatchThrough("top", {{0.1, -1, 0.3}, {0.4, -1, 0.3}, {0.4, 1, 0.3}, {0.1, 1, 0.3}}, 0.5)}, {}, {}};
  RigidBodyProblem problem = TwoStepProblem();
  const std::vector<SwingTrajectory> swings = OneSwing(0, 0.4, 0.9, 0.08);
  const RigidSwing point = FreeSwingsOf(block, problem, swings, {0, 1}).at(0);
  problem.feet[0].radius_m = 0.02;
  const RigidSwing sphere = FreeSwingsOf(block, problem, swings, {0, 1}).at(0);
  ASSERT_EQ(sphere.planes.size(), point.planes.size());
  double most = 0.0;
  for (std::size_t i = 0; i < point.planes.size(); ++i) {
    EXPECT_NEAR(sphere.planes[i].offset_m - point.planes[i].offset_m, 0.02 * (1.0 - point.planes[i].normal_W.z()),
                1e-12);
    most = std::max(most, sphere.planes[i].offset_m - point.planes[i].offset_m);
  }
  EXPECT_NEAR(most, 0.02, 1e-6) << "beside the riser by the whole radius";
}

TEST(FreeSwings, OfAProblemStartWhereTheFootHasRolledTo) {
  RigidBodyProblem problem = TwoStepProblem();
  problem.swings = {{0, 2, 0.05, 0.2}};
  RigidBodyMotion motion;
  for (const RigidStance& stance : problem.stances) motion.X_WF.push_back(stance.X_WF);
  problem.stances[0].moved_W = {Vector3::Zero(), Vector3(0.01, 0.0, 0.0)};
  const SwingTrajectory given = SwingOf(problem, motion, 0, 1.0);
  EXPECT_EQ(given.foot, 0);
  EXPECT_DOUBLE_EQ(given.start_s, 1.4);
  EXPECT_DOUBLE_EQ(given.end_s, 1.9);
  EXPECT_DOUBLE_EQ(given.X_WF_start.translation().x(), 0.01);
  EXPECT_DOUBLE_EQ(given.X_WF_end.translation().x(), 0.3);
  EXPECT_EQ(given.lift_m, 0.05);
  EXPECT_EQ(given.cruise, 0.2);
  EXPECT_TRUE(given.detour_W.empty());
  problem.swings[0].free = true;
  motion.detours_W = {std::vector<Vector3>(8, Vector3(0.0, 0.0, 0.04))};
  EXPECT_EQ(SwingOf(problem, motion, 0).detour_W, motion.detours_W[0]);
}

TEST(FreeSwings, TakenIntoAProblemTheirPointsAreTheLastNumbers) {
  RigidBodyProblem problem = TwoStepProblem();
  RigidSwing swing{0, 2};
  swing.free = true;
  swing.detour_W = {Vector3(1, 2, 3), Vector3(4, 5, 6)};
  VectorX numbers = VectorX::LinSpaced(4, 10.0, 13.0);
  TakeSwings({swing}, problem, numbers);
  VectorX expected(10);
  expected << 10, 11, 12, 13, 1, 2, 3, 4, 5, 6;
  EXPECT_EQ(numbers, expected);
  ASSERT_EQ(problem.swings.size(), 1U);
  swing.detour_W.pop_back();
  TakeSwings({swing, RigidSwing{1, 3}}, problem, numbers);
  EXPECT_EQ(numbers, VectorX(expected.head(7))) << "the old ones are replaced; a swing that is not free has none";
  TakeSwings({}, problem, numbers);
  EXPECT_EQ(numbers, VectorX(expected.head(4)));
}

}  // namespace
}  // namespace gaitwright
