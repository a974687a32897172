// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/centroidal/centre_of_mass.h"

#include <gtest/gtest.h>

#include <random>

#include "optimisation/centroidal/optimise_zmp.h"
#include "optimisation/centroidal/zmp_knots.h"
#include "tests/optimisation/centroidal/walking_problem.h"

namespace gaitwright {
namespace {

double AtRest(const ZmpProblem& problem, const CentroidalTrajectory& motion) {
  return std::max({(motion.p_WC.front().head<2>() - problem.start_W).norm(), motion.v_WC.front().norm(),
                   motion.a_WC.front().norm(), (motion.p_WC.back().head<2>() - problem.end_W).norm(),
                   motion.v_WC.back().norm(), motion.a_WC.back().norm()});
}

double LeastMargin(const ZmpProblem& problem, const std::vector<Vector2>& p_WZ) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < p_WZ.size(); ++k) {
    const double t = problem.start_s + static_cast<double>(k) * problem.step_s;
    least = std::min(least, SignedDistance(RegionAt(problem.phases[ZmpPhaseAt(problem, t)], t), p_WZ[k]));
  }
  return least;
}

/// The cost as defined for OptimiseZmp, by knots.
double Cost(const ZmpProblem& problem, const ZmpKnots& zmp, const ZmpWeights& weights, const VectorX& x) {
  double cost = 0.0;
  for (const auto& [a, b] : zmp.spans) {
    const ZmpKnot &left = zmp.knots[a], &right = zmp.knots[b];
    const double h = right.time_s - left.time_s;
    for (const ZmpKnot* knot : {&left, &right}) {
      if (knot->size == 0) continue;
      const Vector2 off = knot->At(x) - PreferredAt(problem.phases[knot->phase], knot->time_s);
      cost += weights.centre * 0.5 * h * off.squaredNorm();
    }
    cost += weights.smooth / h * (right.At(x) - left.At(x)).squaredNorm();
  }
  return cost;
}

/// The knots' variables for a ZMP on the grid.
VectorX VariablesOf(const ZmpProblem& problem, const ZmpKnots& zmp, const std::vector<Vector2>& p_WZ) {
  VectorX x = VectorX::Zero(zmp.num_variables);
  for (const ZmpKnot& knot : zmp.knots) {
    if (knot.size == 0) continue;
    const auto k = static_cast<std::size_t>(std::lround((knot.time_s - problem.start_s) / problem.step_s));
    const MatrixX basis = knot.basis.leftCols(knot.size);
    x.segment(knot.first, knot.size) =
        (basis.transpose() * basis).inverse() * basis.transpose() * (p_WZ[k] - knot.origin_W);
  }
  return x;
}

TEST(CentreOfMass, BothMethodsStartAndEndAtRestInTheSupports) {
  for (const auto& problem : {synthetic::Biped(6), synthetic::Trot(10)}) {
    for (const std::string method : {"optimised", "closed-form"}) {
      CentreOfMassOptions options;
      options.method = method;
      const Result<CentreOfMassPlan> plan = PlanCentreOfMass(problem, options);
      ASSERT_TRUE(plan.ok()) << method << ": " << plan.failure().message;
      EXPECT_LT(AtRest(problem, plan->trajectory), 1e-6) << method;
      EXPECT_GT(LeastMargin(problem, plan->trajectory.p_WZ), -1e-6) << method;
    }
  }
}

TEST(CentreOfMass, AnOnlyPhaseHasRoomForBothEnds) {
  ZmpProblem sway;
  sway.omega_rad_s = 4.0;
  sway.end_W = Vector2(0.02, 0.01);
  const Polygon sole = synthetic::Sole(Vector2::Zero(), Vector2(0.1, 0.1));
  synthetic::AddPhase(sway, 2.0, sole, sole);
  synthetic::Finish(sway);
  for (const char* method : {"optimised", "closed-form", "preview"}) {
    CentreOfMassOptions options;
    options.method = method;
    const Result<CentreOfMassPlan> plan = PlanCentreOfMass(sway, options);
    ASSERT_TRUE(plan.ok()) << method << ": " << plan.failure().message;
    EXPECT_LT(plan->trajectory.v_WC.front().norm(), 1e-6) << method;
    EXPECT_LT(plan->trajectory.v_WC.back().norm(), 1e-6) << method;
    EXPECT_LT((plan->trajectory.p_WC.back().head<2>() - sway.end_W).norm(), 1e-6) << method;
    EXPECT_LT(AtRest(sway, plan->trajectory), 1e-3) << method;
  }
}

TEST(CentreOfMass, AMarginIsKept) {
  const ZmpProblem problem = synthetic::Biped(6);
  for (const double margin_m : {0.01, 0.03, 0.045}) {
    CentreOfMassOptions options;
    options.zmp_margin_m = margin_m;
    options.smooth_weight = 0.1;  // pulls the ZMP to the edges
    const Result<CentreOfMassPlan> plan = PlanCentreOfMass(problem, options);
    ASSERT_TRUE(plan.ok()) << plan.failure().message;
    EXPECT_GT(plan->margin_min_m, margin_m - 1e-9);
    EXPECT_LT(plan->margin_min_m, margin_m + 1e-3);
    EXPECT_LT(AtRest(problem, plan->trajectory), 1e-6);
  }
}

TEST(CentreOfMass, StandingStaysWhereItIs) {
  ZmpProblem problem;
  synthetic::AddPhase(problem, 2.0, synthetic::Sole({0, 0}, {0.1, 0.1}), synthetic::Sole({0, 0}, {0.1, 0.1}));
  synthetic::Finish(problem);
  const Result<CentreOfMassPlan> plan = PlanCentreOfMass(problem, {});
  ASSERT_TRUE(plan.ok()) << plan.failure().message;
  for (const Vector3& p : plan->trajectory.p_WC) EXPECT_LT(p.head<2>().norm(), 1e-9);
}

TEST(CentreOfMass, WhatTheMultibodyAddsIsCountered) {
  ZmpProblem problem = synthetic::Biped(4);
  for (std::size_t k = 0; k < problem.zmp_offset.size(); ++k) {
    const double u = static_cast<double>(k) / static_cast<double>(problem.zmp_offset.size() - 1);
    problem.zmp_offset[k] = Vector2(0.01, -0.02) * std::pow(std::sin(10.0 * u) * std::sin(3.14159265358979 * u), 2);
  }
  const Result<CentreOfMassPlan> plan = PlanCentreOfMass(problem, {});
  ASSERT_TRUE(plan.ok()) << plan.failure().message;
  EXPECT_LT(AtRest(problem, plan->trajectory), 1e-6);
}

TEST(OptimiseZmp, NothingNearIsBetter) {
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  for (const auto& problem : {synthetic::Biped(4), synthetic::Trot(6)}) {
    ZmpWeights weights;
    const auto guess = PlanCentreOfMass(problem, {.method = "closed-form"})->trajectory.p_WZ;
    const Result<OptimisedZmp> found = OptimiseZmp(problem, weights, guess);
    ASSERT_TRUE(found.ok()) << found.failure().message;
    const ZmpKnots zmp = *PlaceZmpKnots(problem, 0.0, weights.knot_spacing_s);
    const VectorX x = VariablesOf(problem, zmp, found->p_WZ);
    const double cost = Cost(problem, zmp, weights, x);
    // The rows of the end constraints, column by column, for moves that keep them.
    MatrixX rows(4, zmp.num_variables);
    const auto ends = [&](const VectorX& at) {
      const auto motion = PendulumMotion(problem, zmp.Sample(at));
      return Eigen::Vector4d(motion.v_WC.front().x(), motion.v_WC.front().y(), motion.p_WC.back().x(),
                             motion.p_WC.back().y());
    };
    const Eigen::Vector4d here = ends(x);
    for (int v = 0; v < zmp.num_variables; ++v) rows.col(v) = ends(x + VectorX::Unit(zmp.num_variables, v)) - here;
    const MatrixX inverse = rows.transpose() * (rows * rows.transpose()).inverse();
    int tried = 0;
    for (int trial = 0; trial < 200; ++trial) {
      VectorX move = VectorX::NullaryExpr(zmp.num_variables, [&](Eigen::Index) { return 1e-3 * normal(random); });
      move -= inverse * (rows * move);
      bool inside = true;
      for (const ZmpKnot& knot : zmp.knots) {
        inside = inside &&
                 (knot.size == 0 || (NearestPoint(knot.region_W, knot.At(x + move)) - knot.At(x + move)).norm() < 1e-9);
      }
      if (!inside) continue;
      ++tried;
      EXPECT_GT(Cost(problem, zmp, weights, x + move), cost);
    }
    EXPECT_GT(tried, 50);
  }
}

TEST(CentreOfMass, WhatCannotBeNamesThePhaseAndHowFar) {
  ZmpProblem problem = synthetic::Biped(4);
  problem.end_W.x() += 0.3;  // beyond the last soles
  synthetic::Finish(problem);
  for (const std::string method : {"optimised", "closed-form"}) {
    const Result<CentreOfMassPlan> plan = PlanCentreOfMass(problem, {.method = method});
    ASSERT_FALSE(plan.ok()) << method;
    EXPECT_EQ(plan.failure().kind, FailureKind::kInfeasible);
    EXPECT_EQ(plan.failure().code, FailureCode::kZmpSupport);
    EXPECT_EQ(plan.failure().message.rfind("in phase 8", 0), 0U) << plan.failure().message;
    EXPECT_NE(plan.failure().message.find(" mm"), std::string::npos) << plan.failure().message;
  }
}

TEST(CentreOfMass, OptimisationStandsShorterThanTheClosedForm) {
  const ZmpProblem hasty = synthetic::Biped(4, 0.25, 0.15);
  const Result<CentreOfMassPlan> closed_form = PlanCentreOfMass(hasty, {.method = "closed-form"});
  ASSERT_FALSE(closed_form.ok());
  EXPECT_EQ(closed_form.failure().message.rfind("in phase 0, the ZMP at", 0), 0U) << closed_form.failure().message;
  const Result<CentreOfMassPlan> plan = PlanCentreOfMass(hasty, {});
  ASSERT_TRUE(plan.ok()) << plan.failure().message;
  EXPECT_LT(AtRest(hasty, plan->trajectory), 1e-6);
  EXPECT_GT(plan->margin_min_m, -1e-6);
}

TEST(CentreOfMass, AnUnknownMethodIsRefusedWithTheList) {
  try {
    (void)PlanCentreOfMass(synthetic::Biped(2), {.method = "magic"});
    FAIL();
  } catch (const InvalidArgument& error) {
    EXPECT_NE(std::string(error.what()).find("'optimised', 'closed-form', 'preview'"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace gaitwright
