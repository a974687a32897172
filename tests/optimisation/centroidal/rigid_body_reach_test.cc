// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "kinematics/base/non_finite.h"
#include "kinematics/spatial/rotation.h"
#include "optimisation/centroidal/rigid_body_terms.h"
#include "tests/optimisation/centroidal/own_variables.h"
#include "tests/optimisation/centroidal/rigid_bodies.h"

namespace gaitwright {
namespace {

/// Unknowns of a walker at a constant place and orientation, without angular momentum.
VectorX ReachStill(const RigidBodyUnknowns& unknowns, const Vector3& p_WC, const Vector3& angles_rad) {
  VectorX x = VectorX::Zero(unknowns.size());
  for (std::size_t i = 2; i < unknowns.nodes_s().size(); ++i) {
    if (unknowns.ControlPoint(i) >= 0) x.segment<3>(unknowns.ControlPoint(i)) = p_WC;
  }
  for (std::size_t k = 1; k + 1 < unknowns.nodes_s().size(); ++k)
    x.segment<3>(unknowns.Angles(k).parts[0].start) = angles_rad;
  return x;
}

/// Rows of a workspace for a foot at a place relative to the centre of mass, in B.
VectorX WorkspaceRows(const RigidFoot& foot, const Vector3& p_CF_B) {
  VectorX rows(static_cast<Eigen::Index>(foot.workspace_B.size()));
  for (Eigen::Index i = 0; i < rows.size(); ++i)
    rows[i] = foot.workspace_B[static_cast<std::size_t>(i)].normal.dot(p_CF_B);
  return rows;
}

TEST(RigidBodyReach, IsTheFootholdAsTheTurnedBodySeesIt) {
  const RigidBodyProblem problem = rigid_bodies::Walker();
  const RigidBodyUnknowns unknowns(problem, 0.1, 3);
  const RigidBodyTerms terms(problem, unknowns);
  const Vector3 angles(0.1, -0.2, 0.4);
  VectorX x = ReachStill(unknowns, {0.3, 0.05, 0.6}, angles);
  x.segment<2>(unknowns.Foothold(1).parts[0].start) = Vector2(0.04, -0.02);
  for (const std::size_t k : {6U, 8U, 10U}) {
    const double t = unknowns.nodes_s()[k];
    const Vector3 p_CF_W = unknowns.Foothold(1).At(x) - unknowns.CentreOfMass(t).At(x);
    const VectorX value = ValueOf(terms.Reach(1, t, 0.0), x);
    EXPECT_LT((value - WorkspaceRows(problem.feet[0], RotationOf(angles).transpose() * p_CF_W)).norm(), 1e-12) << t;
  }
}

TEST(RigidBodyReach, HasNoLowerBoundAndTheMarginLowersEachUpperOne) {
  const RigidBodyProblem problem = rigid_bodies::Walker();
  const RigidBodyUnknowns unknowns(problem, 0.1, 3);
  const RigidBodyTerms terms(problem, unknowns);
  const Constraint whole = terms.Reach(3, 0.4, 0.0), less = terms.Reach(3, 0.4, 0.013);
  ASSERT_EQ(whole.upper.size(), 6);
  for (Eigen::Index i = 0; i < 6; ++i) {
    EXPECT_EQ(whole.lower[i], -kInfinity);
    EXPECT_DOUBLE_EQ(whole.upper[i], problem.feet[1].workspace_B[static_cast<std::size_t>(i)].offset);
    EXPECT_NEAR(whole.upper[i] - less.upper[i], 0.013, 1e-15);
  }
  EXPECT_EQ(whole.name, "reach of foot 1 at 0.400 s");
}

TEST(RigidBodyReach, BetweenNodesABodyWithoutMomentumKeepsItsAttitude) {
  const RigidBodyProblem problem = rigid_bodies::Walker();
  const RigidBodyUnknowns unknowns(problem, 0.1, 3);
  const RigidBodyTerms terms(problem, unknowns);
  const Vector3 angles(0.05, 0.1, 0.6);
  const VectorX x = ReachStill(unknowns, {0.3, 0.0, 0.62}, angles);
  const double from = unknowns.nodes_s()[7], to = unknowns.nodes_s()[8];
  for (const double share : {0.25, 0.5, 0.9}) {
    const double t = from + share * (to - from);
    const Vector3 p_CF_W = unknowns.Foothold(1).At(x) - unknowns.CentreOfMass(t).At(x);
    EXPECT_LT(
        (ValueOf(terms.Reach(1, t, 0.0), x) - WorkspaceRows(problem.feet[0], RotationOf(angles).transpose() * p_CF_W))
            .norm(),
        1e-12);
  }
}

TEST(RigidBodyReach, IsContinuousThroughANode) {
  const RigidBodyProblem problem = rigid_bodies::Trotter();
  const RigidBodyUnknowns unknowns(problem, 0.08, 3);
  const RigidBodyTerms terms(problem, unknowns);
  const VectorX x = Random(unknowns, 21);
  constexpr double kStep = 1e-7;
  for (std::size_t k = 2; k + 2 < unknowns.nodes_s().size(); k += 3) {
    const double t = unknowns.nodes_s()[k];
    const VectorX at = ValueOf(terms.Reach(0, t, 0.0), x);
    EXPECT_LT((ValueOf(terms.Reach(0, t - kStep, 0.0), x) - at).norm(), 1e-4) << t;
    EXPECT_LT((ValueOf(terms.Reach(0, t + kStep, 0.0), x) - at).norm(), 1e-4) << t;
    EXPECT_GT((ValueOf(terms.Reach(0, t + 0.02, 0.0), x) - at).norm(), 1e-4) << t << ": the body moves";
  }
}

TEST(RigidBodyReach, AtANodeNothingOfTheIntervalsBesideItIsSeen) {
  const RigidBodyProblem problem = rigid_bodies::Walker();
  const RigidBodyUnknowns unknowns(problem, 0.1, 3);
  const RigidBodyTerms terms(problem, unknowns);
  const std::size_t k = 7;
  const Constraint rows = terms.Reach(1, unknowns.nodes_s()[k], 0.0);
  const auto sees = [&](const AffineVector& vector) {
    return std::find(rows.variables.begin(), rows.variables.end(), vector.parts[0].start) != rows.variables.end();
  };
  EXPECT_TRUE(sees(unknowns.Angles(k)));
  EXPECT_FALSE(sees(unknowns.Angles(k + 1)));
  EXPECT_FALSE(sees(unknowns.Momentum(k)));
}

TEST(RigidBodyReach, ASwingBeginsAndEndsOnTheFootholdsOfItsStances) {
  RigidBodyProblem problem = rigid_bodies::Walker();
  problem.swings = {{0, 1, 0.12}, {3, 4, 0.08}};
  const RigidBodyUnknowns unknowns(problem, 0.08, 3);
  const RigidBodyTerms terms(problem, unknowns);
  const VectorX x = Random(unknowns, 4);
  for (const std::size_t swing : {0U, 1U}) {
    const RigidSwing& of = problem.swings[swing];
    const double lift_off_s = problem.stances[of.from].end_s, touch_down_s = problem.stances[of.to].start_s;
    EXPECT_LT(
        (ValueOf(terms.SwingReach(swing, 0.0, 0.0), x) - ValueOf(terms.Reach(of.from, lift_off_s, 0.0), x)).norm(),
        1e-12);
    EXPECT_LT(
        (ValueOf(terms.SwingReach(swing, 1.0, 0.0), x) - ValueOf(terms.Reach(of.to, touch_down_s, 0.0), x)).norm(),
        1e-12);
    EXPECT_GT(
        (ValueOf(terms.SwingReach(swing, 0.5, 0.0), x) - ValueOf(terms.Reach(of.to, touch_down_s, 0.0), x)).norm(),
        0.01);
  }
}

TEST(RigidBodyReach, ASwingIsHeldInTheWorkspaceOfTheAirWhereThereIsOne) {
  RigidBodyProblem problem = rigid_bodies::Walker();
  problem.swings = {{0, 1, 0.1}};
  problem.feet[0].workspace_in_air_B = {{Vector3::UnitZ(), -0.2}, {-Vector3::UnitZ(), 0.9}};
  const RigidBodyUnknowns unknowns(problem, 0.1, 3);
  const RigidBodyTerms terms(problem, unknowns);
  const Constraint air = terms.SwingReach(0, 0.5, 0.0), ground = terms.Reach(0, 0.1, 0.0);
  ASSERT_EQ(air.upper.size(), 2);
  EXPECT_DOUBLE_EQ(air.upper[0], -0.2);
  EXPECT_DOUBLE_EQ(air.upper[1], 0.9);
  EXPECT_EQ(ground.upper.size(), 6);
}

TEST(RigidBodyReach, ClearanceAlongTheVerticalDoesNotDependOnYaw) {
  const RigidBodyProblem problem = rigid_bodies::Walker();
  const RigidBodyUnknowns unknowns(problem, 0.1, 3);
  const RigidBodyTerms terms(problem, unknowns);
  const RigidClearance up{unknowns.nodes_s()[6], {0.3, -0.1, -0.05}, Vector3::UnitZ(), 0.2};
  const RigidClearance forward{unknowns.nodes_s()[6], {0.3, -0.1, -0.05}, Vector3::UnitX(), 0.2};
  const Vector3 place(0.3, 0.0, 0.6);
  const auto value = [&](const RigidClearance& clearance, double yaw) {
    return ValueOf(terms.Clearance(clearance), ReachStill(unknowns, place, {0.0, 0.0, yaw}))[0];
  };
  EXPECT_NEAR(value(up, 0.0), value(up, 1.3), 1e-12);
  // A rotation by 90 degrees to the left moves the point's x to y and its y to -x.
  EXPECT_NEAR(value(forward, M_PI / 2.0) - value(forward, 0.0), 0.1 - 0.3, 1e-12);
}

TEST(RigidBodyReach, SwingClearanceIsAffineAndHasARowForEachPlane) {
  RigidBodyProblem problem = rigid_bodies::Walker();
  problem.swings = {{0, 1}};
  problem.swings[0].detour_W.assign(6, {0.01, 0.0, 0.1});
  problem.swings[0].free = true;
  problem.swings[0].planes = {
      {0.2, Vector3::UnitZ(), 0.02}, {0.5, Vector3(0.6, 0.0, 0.8), -0.3}, {0.8, Vector3::UnitY(), 0.1}};
  const RigidBodyUnknowns unknowns(problem, 0.1, 3);
  const Constraint rows = RigidBodyTerms(problem, unknowns).SwingClearance(0);
  EXPECT_TRUE(rows.affine);
  EXPECT_EQ(rows.name, "clearance of foot 0 in the air from 0.300 s on");
  ASSERT_EQ(rows.lower.size(), 3);
  EXPECT_LT((rows.lower - Vector3(0.02, -0.3, 0.1)).norm(), 1e-15);
  for (Eigen::Index i = 0; i < 3; ++i) EXPECT_EQ(rows.upper[i], kInfinity);
  const VectorX x = Random(unknowns, 1), y = Random(unknowns, 2);
  const VectorX mixed = ValueOf(rows, 0.3 * x + 0.7 * y);
  EXPECT_GT((ValueOf(rows, x) - ValueOf(rows, y)).norm(), 1e-3);
  EXPECT_LT((mixed - 0.3 * ValueOf(rows, x) - 0.7 * ValueOf(rows, y)).norm(), 1e-12);
}

}  // namespace
}  // namespace gaitwright
