// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <limits>

#include "kinematics/base/result.h"
#include "kinematics/trajectory/swing_curve.h"
#include "optimisation/centroidal/rigid_body_motion.h"
#include "optimisation/centroidal/rigid_body_terms.h"
#include "tests/optimisation/centroidal/own_variables.h"
#include "tests/optimisation/centroidal/rigid_bodies.h"
#include "tests/optimisation/numerics/derivative_check.h"

namespace gaitwright {
namespace {

TEST(RigidBodySwings, RowsOfSwingsHaveTheirDerivatives) {
  for (RigidBodyProblem problem : {rigid_bodies::Hopper(), rigid_bodies::Trotter(), rigid_bodies::SoledWalker()}) {
    problem.swings = {{0, 1, 0.1}, {0, 1, 0.1}};
    problem.swings[1].detour_W.assign(6, {0.01, 0.0, 0.1});
    problem.swings[1].free = true;
    for (const double share : {0.3, 0.6}) problem.swings[1].planes.push_back({share, Vector3(0.6, 0.0, 0.8), 0.02});
    const RigidBodyUnknowns unknowns(problem, 0.08, 3);
    const RigidBodyTerms terms(problem, unknowns);
    const VectorX x = Random(unknowns, 7);
    for (const std::size_t swing : {0U, 1U}) {
      for (const double share : {0.1, 0.35, 0.5, 0.9}) {
        const Constraint reach = terms.SwingReach(swing, share, 0.0);
        SCOPED_TRACE(reach.name);
        ExpectDerivative(reach.function, Own(reach.variables, x));
      }
    }
    const Constraint clearance = terms.SwingClearance(1);
    ExpectDerivative(clearance.function, Own(clearance.variables, x));
  }
}

/// Compares with a curve that has the control points of the unknowns.
TEST(RigidBodySwings, AFreeSwingIsTheCurveOfItsControlPoints) {
  RigidBodyProblem problem = rigid_bodies::Walker();
  problem.swings = {{0, 1}};
  problem.swings[0].detour_W.assign(8, Vector3::Zero());
  problem.swings[0].free = true;
  problem.swings[0].planes = {{0.25, Vector3(0.6, 0.0, 0.8), 0.3}, {0.5, Vector3::UnitZ(), -0.1}};
  const RigidBodyUnknowns unknowns(problem, 0.08, 3);
  const VectorX x = Random(unknowns, 11);
  SwingCurve curve{0.0, 1.0, Pose::Identity(), Pose::Identity()};
  curve.X_WF_start.translation() = unknowns.Foothold(0).At(x);
  curve.X_WF_end.translation() = unknowns.Foothold(1).At(x);
  curve.detour_W = MotionOf(problem, unknowns, x).detours_W.at(0);
  ASSERT_EQ(curve.detour_W.size(), 8U);
  EXPECT_GT(curve.detour_W[3].norm(), 0.01);
  for (const double share : {0.0, 0.1, 0.5, 0.77, 1.0}) {
    const FrameMotion at = Evaluate(curve, share);
    EXPECT_LT((unknowns.InSwing(0, share).At(x) - at.X_WF.translation()).norm(), 1e-12) << share;
    if (share > 0.0 && share < 1.0) {
      EXPECT_LT((unknowns.InSwingAcceleration(0, share).At(x) - at.a_WF).norm(), 1e-9) << share;
    }
  }
  const Constraint rows = RigidBodyTerms(problem, unknowns).SwingClearance(0);
  const VectorX value = ValueOf(rows, x);
  ASSERT_EQ(value.size(), 2);
  for (Eigen::Index i = 0; i < 2; ++i) {
    const SwingPlane& plane = problem.swings[0].planes[static_cast<std::size_t>(i)];
    EXPECT_NEAR(value[i], plane.normal_W.dot(Evaluate(curve, plane.share).X_WF.translation()), 1e-12);
    EXPECT_DOUBLE_EQ(rows.lower[i], plane.offset_m);
  }
}

TEST(RigidBodySwings, SwingReachIsThatOfTheSwingsCurve) {
  RigidBodyProblem problem = rigid_bodies::Walker();
  problem.swings = {{0, 1, 0.12}};
  const RigidBodyUnknowns unknowns(problem, 0.08, 3);
  VectorX x = VectorX::Zero(unknowns.size());  // vertical all the time
  for (std::size_t i = 2; i < unknowns.nodes_s().size(); ++i)
    x.segment<3>(unknowns.ControlPoint(i)) = Vector3(0.1 * static_cast<double>(i), 0.02, 0.6);
  x.segment<2>(unknowns.Foothold(1).parts[0].start) = Vector2(0.07, -0.03);
  const RigidStance &from = problem.stances[0], &to = problem.stances[1];
  SwingCurve curve{from.end_s, to.start_s, from.X_WF, to.X_WF, 0.12};
  curve.X_WF_end.translation() = unknowns.Foothold(1).At(x);
  for (const double share : {0.1, 0.3, 0.5, 0.8}) {
    const double time_s = from.end_s + share * (to.start_s - from.end_s);
    const Constraint rows = RigidBodyTerms(problem, unknowns).SwingReach(0, share, 0.01);
    const VectorX value = ValueOf(rows, x);
    const Vector3 p_CF = Evaluate(curve, time_s).X_WF.translation() - unknowns.CentreOfMass(time_s).At(x);
    ASSERT_EQ(value.size(), static_cast<Eigen::Index>(problem.feet[0].workspace_B.size()));
    for (std::size_t i = 0; i < problem.feet[0].workspace_B.size(); ++i) {
      const WorkspaceSide& side = problem.feet[0].workspace_B[i];
      EXPECT_NEAR(value[static_cast<Eigen::Index>(i)], side.normal.dot(p_CF), 1e-12) << share;
      EXPECT_NEAR(rows.upper[static_cast<Eigen::Index>(i)], side.offset - 0.01, 1e-12);
    }
  }
}

TEST(RigidBodySwings, ThatAreNoneAreRefused) {
  RigidBodyProblem problem = rigid_bodies::Walker();
  problem.swings = {{0, 1}};
  problem.swings[0].detour_W.assign(8, Vector3::Zero());
  problem.swings[0].free = true;
  EXPECT_NO_THROW(CheckRigidBodyProblem(problem));
  RigidBodyProblem odd = problem, outside = problem, endless = problem;
  odd.swings[0].detour_W.pop_back();
  EXPECT_THROW(CheckRigidBodyProblem(odd), InvalidArgument);
  outside.swings[0].shares = {1.1};
  EXPECT_THROW(CheckRigidBodyProblem(outside), InvalidArgument);
  endless.swings[0].planes = {{0.5, Vector3::UnitZ(), std::numeric_limits<double>::infinity()}};
  EXPECT_THROW(CheckRigidBodyProblem(endless), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
