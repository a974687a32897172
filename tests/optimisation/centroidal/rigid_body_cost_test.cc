// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/centroidal/rigid_body_cost.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "kinematics/trajectory/swing_curve.h"
#include "tests/optimisation/centroidal/own_variables.h"
#include "tests/optimisation/centroidal/rigid_bodies.h"
#include "tests/optimisation/numerics/derivative_check.h"

namespace gaitwright {
namespace {

constexpr RigidBodyWeights kNoWeights = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0};

double WeighedCost(const RigidBodyProblem& problem, const RigidBodyUnknowns& unknowns, const RigidBodyWeights& weights,
                   const VectorX& x) {
  double sum = 0.0;
  for (const Residual& residual : RigidBodyCost(problem, unknowns, weights)) {
    VectorX value;
    residual.function(Own(residual.variables, x), value, nullptr);
    sum += value.squaredNorm();
  }
  return sum;
}

RigidBodyWeights Only(double RigidBodyWeights::*weight, double value = 1.0) {
  RigidBodyWeights weights = kNoWeights;
  weights.*weight = value;
  return weights;
}

const std::vector<double RigidBodyWeights::*> kEachWeight = {
    &RigidBodyWeights::force_rate, &RigidBodyWeights::momentum, &RigidBodyWeights::tilt,
    &RigidBodyWeights::stance,     &RigidBodyWeights::path,     &RigidBodyWeights::swing_jerk};

/// A walker with a path to follow and a free swing, so that each weight has rows.
RigidBodyProblem WalkerWithAllCosts() {
  RigidBodyProblem problem = rigid_bodies::Walker();
  problem.path = {{0.0, 1.9}, {problem.start.p_WC, problem.goal.p_WC}, {Vector3::Zero(), Vector3(0.0, 0.0, 0.3)}};
  problem.swings = {{0, 1}};
  problem.swings[0].detour_W.assign(6, {0.01, 0.0, 0.1});
  problem.swings[0].free = true;
  return problem;
}

TEST(RigidBodyCostRows, HaveConstantJacobiansThatAreTheirDerivatives) {
  const RigidBodyProblem problem = WalkerWithAllCosts();
  const RigidBodyUnknowns unknowns(problem, 0.2, 3);
  const VectorX x = Random(unknowns, 3), y = Random(unknowns, 4);
  for (double RigidBodyWeights::*weight : kEachWeight) {
    const std::vector<Residual> rows = RigidBodyCost(problem, unknowns, Only(weight, 2.5));
    int checked = 0;
    for (const Residual& residual : rows) {
      ASSERT_TRUE(residual.affine);
      const VectorX at = Own(residual.variables, x), other = Own(residual.variables, y);
      VectorX value;
      residual.function(at, value, nullptr);
      MatrixX J = MatrixX::Zero(value.size(), at.size()), J_other = J;
      residual.function(at, value, &J);
      residual.function(other, value, &J_other);
      EXPECT_EQ((J - J_other).norm(), 0.0);
      if (J.norm() < 1e-6) continue;  // the weight is zero
      ExpectDerivative(residual.function, at);
      ++checked;
    }
    EXPECT_GT(checked, 3);
  }
}

TEST(RigidBodyCostRows, IsTheSumOfWhatEachWeightCosts) {
  const RigidBodyProblem problem = WalkerWithAllCosts();
  const RigidBodyUnknowns unknowns(problem, 0.1, 3);
  const VectorX x = Random(unknowns, 9);
  double sum = 0.0, factor = 1.0;
  RigidBodyWeights all = kNoWeights;
  for (double RigidBodyWeights::*weight : kEachWeight) {
    const double alone = WeighedCost(problem, unknowns, Only(weight), x);
    EXPECT_GT(alone, 1e-6);
    all.*weight = factor;
    sum += factor * alone;
    factor *= 2.0;
  }
  EXPECT_NEAR(WeighedCost(problem, unknowns, all, x), sum, 1e-9 * sum);
}

TEST(RigidBodyCostRows, ForceRateIsTheIntegralOfTheSquaredRate) {
  const RigidBodyProblem problem = rigid_bodies::Stander();
  const RigidBodyUnknowns unknowns(problem, 0.1, 3);
  VectorX x = rigid_bodies::Wavering(problem, unknowns);
  std::size_t raised = 99;
  for (const BoundForce& force : unknowns.BoundForces()) {
    if (force.force.parts.size() != 1) continue;
    if (raised == 99) raised = force.stance;
    const double t = unknowns.nodes_s()[force.at_node];
    x.segment<3>(force.force.parts[0].start) = Vector3(0.0, 0.0, force.stance == raised ? 0.2 + 0.3 * t : 0.25);
  }
  ASSERT_NE(raised, 99U);
  // The load of one foot grows by 0.3 m g per second; that of the foot with the remainder falls by as much.
  const double expected = 2.0 * 0.3 * 0.3 * problem.duration_s;
  EXPECT_NEAR(WeighedCost(problem, unknowns, Only(&RigidBodyWeights::force_rate, 1.0), x), expected, 1e-9);
}

TEST(RigidBodyCostRows, MomentumIsTheIntegralOfItsSquareBetweenTheGivenEnds) {
  const RigidBodyProblem problem = rigid_bodies::Walker();
  const RigidBodyUnknowns unknowns(problem, 0.1, 3);
  const std::vector<double>& t = unknowns.nodes_s();
  VectorX x = VectorX::Zero(unknowns.size());
  for (std::size_t k = 1; k + 1 < t.size(); ++k)
    x.segment<3>(unknowns.Momentum(k).parts[0].start) = Vector3(0.3, -0.1, 0.2);
  const double ends = 0.5 * (t[1] - t[0]) + 0.5 * (t[t.size() - 1] - t[t.size() - 2]);
  EXPECT_NEAR(WeighedCost(problem, unknowns, Only(&RigidBodyWeights::momentum, 3.0), x), 3.0 * 0.14 * (1.9 - ends),
              1e-9);
}

TEST(RigidBodyCostRows, StanceIsTheIntegralOfAFootsSquaredDistanceFromItsNominalPlace) {
  const RigidBodyProblem problem = rigid_bodies::Stander();
  const RigidBodyUnknowns unknowns(problem, 0.1, 3);
  VectorX x = rigid_bodies::Wavering(problem, unknowns);
  const RigidBodyWeights stance = Only(&RigidBodyWeights::stance, 4.0);
  EXPECT_NEAR(WeighedCost(problem, unknowns, stance, x), 0.0, 1e-12);
  x.segment<2>(unknowns.Foothold(2).parts[0].start) += Vector2(0.03, -0.04);
  EXPECT_NEAR(WeighedCost(problem, unknowns, stance, x), 4.0 * 0.0025 * problem.duration_s, 1e-12);
}

TEST(RigidBodyCostRows, ASoleCountsOnceWhateverItsPointsOfContact) {
  RigidBodyProblem point = rigid_bodies::Stander(), sole = point;
  for (RigidFoot& foot : sole.feet) foot.contacts_F = {{0.03, 0.02, 0.0}, {0.03, -0.02, 0.0}, {-0.03, 0.0, 0.0}};
  const RigidBodyUnknowns of_point(point, 0.1, 3), of_sole(sole, 0.1, 3);
  const auto moved = [&](const RigidBodyUnknowns& unknowns, const RigidBodyProblem& problem) {
    VectorX x = rigid_bodies::Wavering(problem, unknowns);
    x.segment<2>(unknowns.Foothold(1).parts[0].start) += Vector2(0.05, 0.0);
    return WeighedCost(problem, unknowns, Only(&RigidBodyWeights::stance), x);
  };
  EXPECT_GT(moved(of_point, point), 1e-4);
  EXPECT_NEAR(moved(of_sole, sole), moved(of_point, point), 1e-12);
}

TEST(RigidBodyCostRows, SwingJerkIsNearlyTheIntegralOfTheSwingsSquaredJerk) {
  RigidBodyProblem problem = rigid_bodies::Walker();
  problem.swings = {{0, 1}};
  problem.swings[0].detour_W = {{0.0, 0.01, 0.05}, {0.01, 0.0, 0.09}, {0.0, 0.0, 0.11},
                                {0.0, -0.01, 0.1}, {-0.01, 0.0, 0.1}, {0.0, 0.0, 0.06}};
  problem.swings[0].free = true;
  const RigidBodyUnknowns unknowns(problem, 0.1, 3);
  VectorX x = VectorX::Zero(unknowns.size());
  for (int k = 0; k < 18; ++k)
    x[unknowns.Detour(0) + k] = problem.swings[0].detour_W[static_cast<std::size_t>(k / 3)][k % 3];
  SwingCurve curve{0.0, 1.0, Pose::Identity(), Pose::Identity(), 0.0, problem.swings[0].detour_W};
  curve.X_WF_start.translation() = unknowns.Foothold(0).At(x);
  curve.X_WF_end.translation() = unknowns.Foothold(1).At(x);
  constexpr int kFine = 4000;
  double integral = 0.0;
  for (int k = 0; k < kFine; ++k) {
    const Vector3 change = Evaluate(curve, (k + 1.0) / kFine).a_WF - Evaluate(curve, (k + 0.0) / kFine).a_WF;
    integral += change.squaredNorm() * kFine;
  }
  const double cost = WeighedCost(problem, unknowns, Only(&RigidBodyWeights::swing_jerk), x);
  EXPECT_LE(cost, integral) << "means over pieces are no larger";
  EXPECT_GT(cost, 0.9 * integral);
}

TEST(RigidBodyCostRows, AGivenSwingCostsNothing) {
  RigidBodyProblem problem = rigid_bodies::Walker();
  problem.swings = {{0, 1, 0.1}};
  const RigidBodyUnknowns unknowns(problem, 0.1, 3);
  EXPECT_EQ(WeighedCost(problem, unknowns, Only(&RigidBodyWeights::swing_jerk, 10.0), Random(unknowns, 2)), 0.0);
}

TEST(WantedAngles, TurnEvenlyOrAlongThePathThatIsFollowed) {
  RigidBodyProblem problem = rigid_bodies::Walker();
  problem.start.angles_rad = {0.2, 0.1, 0.4};
  problem.goal.angles_rad = {-0.1, 0.3, 1.2};
  EXPECT_LT((WantedAngles(problem, 0.0) - Vector3(0.0, 0.0, 0.4)).norm(), 1e-12) << "level";
  EXPECT_LT((WantedAngles(problem, problem.duration_s / 4.0) - Vector3(0.0, 0.0, 0.6)).norm(), 1e-12);
  EXPECT_LT((WantedAngles(problem, problem.duration_s) - Vector3(0.0, 0.0, 1.2)).norm(), 1e-12);
  problem.path = {{0.0, 1.0, 1.9},
                  std::vector<Vector3>(3, problem.start.p_WC),
                  {{0.0, 0.5, 0.4}, {0.0, 0.5, 0.4}, {0.0, 0.5, 1.2}}};
  EXPECT_LT((WantedAngles(problem, problem.duration_s / 4.0) - Vector3(0.0, 0.0, 0.6)).norm(), 1e-12);
  problem.follows_yaw = true;
  EXPECT_LT((WantedAngles(problem, 0.8) - Vector3(0.0, 0.0, 0.4)).norm(), 1e-12);
  EXPECT_LT((WantedAngles(problem, 1.45) - Vector3(0.0, 0.0, 0.8)).norm(), 1e-12);
}

}  // namespace
}  // namespace gaitwright
