// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/centroidal/optimise_zmp.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include "tests/optimisation/centroidal/walking_problem.h"

namespace gaitwright {
namespace {

std::vector<Vector2> PreferredZmp(const ZmpProblem& problem) {
  std::vector<Vector2> p_WZ;
  for (int k = 0; k < problem.samples; ++k) {
    const double t = problem.start_s + k * problem.step_s;
    p_WZ.push_back(PreferredAt(problem.phases[ZmpPhaseAt(problem, t)], t));
  }
  return p_WZ;
}

OptimisedZmp OptimisedOf(const ZmpProblem& problem, const ZmpWeights& weights = {}) {
  const Result<OptimisedZmp> zmp = OptimiseZmp(problem, weights, PreferredZmp(problem));
  EXPECT_TRUE(zmp.ok()) << zmp.failure().message;
  return zmp.ok() ? *zmp : OptimisedZmp{};
}

/// Integral over time of the squared distance to the preferred ZMP.
double CentringCost(const ZmpProblem& problem, const std::vector<Vector2>& p_WZ) {
  const std::vector<Vector2> preferred = PreferredZmp(problem);
  double sum = 0.0;
  for (std::size_t k = 0; k < p_WZ.size(); ++k) sum += (p_WZ[k] - preferred[k]).squaredNorm() * problem.step_s;
  return sum;
}

/// Integral over time of the squared rate.
double SmoothingCost(const ZmpProblem& problem, const std::vector<Vector2>& p_WZ) {
  double sum = 0.0;
  for (std::size_t k = 0; k + 1 < p_WZ.size(); ++k) sum += (p_WZ[k + 1] - p_WZ[k]).squaredNorm() / problem.step_s;
  return sum;
}

struct WalkingCase {
  const char* name;
  ZmpProblem problem;
};

class OptimiseZmpTest : public testing::TestWithParam<WalkingCase> {};

TEST_P(OptimiseZmpTest, StartsAndEndsAtRestWhereItIsAsked) {
  const ZmpProblem& problem = GetParam().problem;
  const CentroidalTrajectory motion = PendulumMotion(problem, OptimisedOf(problem).p_WZ);
  ASSERT_EQ(motion.size(), problem.samples);
  EXPECT_LT((motion.p_WC.back().head<2>() - problem.end_W).norm(), 1e-6);
  EXPECT_LT(motion.v_WC.front().norm(), 1e-5);
  EXPECT_LT(motion.v_WC.back().norm(), 1e-5);
  const auto middle = static_cast<std::size_t>(problem.samples / 2);
  EXPECT_GT(motion.v_WC[middle].norm(), 0.01) << "it walks in between";
}

TEST_P(OptimiseZmpTest, IsInTheRegionAtEachSample) {
  const ZmpProblem& problem = GetParam().problem;
  const OptimisedZmp zmp = OptimisedOf(problem);
  ASSERT_EQ(zmp.p_WZ.size(), static_cast<std::size_t>(problem.samples));
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < problem.samples; ++k) {
    const double t = problem.start_s + k * problem.step_s;
    const Polygon region = RegionAt(problem.phases[ZmpPhaseAt(problem, t)], t);
    least = std::min(least, SignedDistance(region, zmp.p_WZ[static_cast<std::size_t>(k)]));
  }
  EXPECT_GT(least, -1e-9);
}

TEST_P(OptimiseZmpTest, TheInitialZmpDoesNotMatter) {
  const ZmpProblem& problem = GetParam().problem;
  const std::vector<Vector2> expected = OptimisedOf(problem).p_WZ;
  const std::vector<Vector2> origin(expected.size(), Vector2::Zero());
  const Result<OptimisedZmp> other = OptimiseZmp(problem, {}, origin);
  ASSERT_TRUE(other.ok()) << other.failure().message;
  double largest = 0.0;
  for (std::size_t k = 0; k < expected.size(); ++k) largest = std::max(largest, (expected[k] - other->p_WZ[k]).norm());
  EXPECT_LT(largest, 1e-4);
}

/// A problem transformed to another frame; a mirror image reverses the order of corners.
ZmpProblem SeenIn(const Eigen::Affine2d& X, const ZmpProblem& problem) {
  ZmpProblem seen = problem;
  seen.start_W = X * problem.start_W;
  seen.end_W = X * problem.end_W;
  const auto move = [&](Polygon& region) {
    for (Vector2& corner : region) corner = X * corner;
    if (X.linear().determinant() < 0.0) std::reverse(region.begin(), region.end());
  };
  for (ZmpPhase& phase : seen.phases) {
    move(phase.region_start);
    move(phase.region_end);
    phase.preferred_start = X * phase.preferred_start;
    phase.preferred_end = X * phase.preferred_end;
  }
  for (Vector2& d : seen.zmp_offset) d = X.linear() * d;
  return seen;
}

TEST_P(OptimiseZmpTest, IsTheSameInAMovedTurnedOrMirroredFrame) {
  ZmpProblem problem = GetParam().problem;
  for (std::size_t k = 0; k < problem.zmp_offset.size(); ++k)
    problem.zmp_offset[k] = Vector2(0.002, 0.001) * std::sin(0.03 * static_cast<double>(k));
  const std::vector<Vector2> p_WZ = OptimisedOf(problem).p_WZ;
  Eigen::Affine2d moved = Eigen::Affine2d::Identity(), turned = moved, mirrored = moved;
  moved.translation() = Vector2(0.8, -1.1);
  turned.linear() = Eigen::Rotation2Dd(0.7).toRotationMatrix();
  mirrored.linear() = Vector2(1.0, -1.0).asDiagonal();
  for (const Eigen::Affine2d& X : {moved, turned, mirrored}) {
    const std::vector<Vector2> seen = OptimisedOf(SeenIn(X, problem)).p_WZ;
    ASSERT_EQ(seen.size(), p_WZ.size());
    double largest = 0.0;
    for (std::size_t k = 0; k < seen.size(); ++k) largest = std::max(largest, (seen[k] - X * p_WZ[k]).norm());
    EXPECT_LT(largest, 1e-4) << X.matrix();
  }
}

TEST_P(OptimiseZmpTest, EachWeightLowersItsOwnCost) {
  const ZmpProblem& problem = GetParam().problem;
  const std::vector<Vector2> centred = OptimisedOf(problem, {.smooth = 1e-6}).p_WZ;
  const std::vector<Vector2> smooth = OptimisedOf(problem, {.smooth = 1.0}).p_WZ;
  EXPECT_LT(CentringCost(problem, centred), CentringCost(problem, smooth));
  EXPECT_LT(SmoothingCost(problem, smooth), SmoothingCost(problem, centred));
}

INSTANTIATE_TEST_SUITE_P(Walks, OptimiseZmpTest,
                         testing::Values(WalkingCase{"biped", synthetic::Biped(3)},
                                         WalkingCase{"trot", synthetic::Trot(4)}),
                         [](const auto& walk) { return std::string(walk.param.name); });

TEST(OptimiseZmp, KeepsTheMarginToTheEdgeOfASole) {
  const ZmpProblem problem = synthetic::Biped(2);
  const OptimisedZmp zmp = OptimisedOf(problem, {.margin_m = 0.02});
  ASSERT_EQ(zmp.margin_m.size(), zmp.p_WZ.size());
  bool asked = false;
  for (int k = 0; k < problem.samples; ++k) {
    const auto i = static_cast<std::size_t>(k);
    const double t = problem.start_s + k * problem.step_s;
    const Polygon region = RegionAt(problem.phases[ZmpPhaseAt(problem, t)], t);
    EXPECT_GE(zmp.margin_m[i], 0.0);
    EXPECT_LE(zmp.margin_m[i], 0.02 + 1e-12);
    EXPECT_GT(SignedDistance(region, zmp.p_WZ[i]), zmp.margin_m[i] - 1e-9) << t;
    asked = asked || zmp.margin_m[i] > 0.0199;
  }
  EXPECT_TRUE(asked);
}

TEST(OptimiseZmp, StandingStillKeepsTheZmpUnderTheBody) {
  ZmpProblem problem = synthetic::Biped(0, 0.25, 1.0);
  ASSERT_EQ(problem.phases.size(), 1U);
  problem.start_W = problem.end_W = Vector2(0.02, -0.03);
  problem.phases[0].preferred_start = problem.phases[0].preferred_end = problem.start_W;
  for (const Vector2& p : OptimisedOf(problem).p_WZ) EXPECT_LT((p - problem.start_W).norm(), 1e-6);
}

TEST(OptimiseZmp, APhaseTooShortForAnInnerKnotLeavesNoChoice) {
  ZmpProblem problem;
  problem.phases.clear();
  synthetic::AddPhase(problem, 2.0 * problem.step_s, synthetic::Sole({0.0, 0.0}, {0.1, 0.05}),
                      synthetic::Sole({0.0, 0.0}, {0.1, 0.05}));
  synthetic::Finish(problem);
  const OptimisedZmp zmp = OptimisedOf(problem);
  EXPECT_EQ(zmp.variables, 0);
  EXPECT_EQ(zmp.p_WZ.size(), 3U);
  for (const Vector2& p : zmp.p_WZ) EXPECT_LT(p.norm(), 1e-12);
}

TEST(OptimiseZmp, AStartThatNoSupportCanHoldIsRefusedWithItsDistance) {
  ZmpProblem problem = synthetic::Biped(2);
  problem.start_W = Vector2(0.0, 0.6);
  const Result<OptimisedZmp> zmp = OptimiseZmp(problem, {}, PreferredZmp(problem));
  ASSERT_FALSE(zmp.ok());
  const Failure& failure = zmp.failure();
  EXPECT_EQ(failure.kind, FailureKind::kInfeasible);
  EXPECT_EQ(failure.code, FailureCode::kZmpSupport);
  EXPECT_EQ(failure.stage, "PlanCentreOfMass");
  ASSERT_TRUE(failure.violation);
  EXPECT_EQ(failure.violation->law, Law::kZmpSupport);
  EXPECT_EQ(failure.violation->unit, "m");
  EXPECT_EQ(failure.violation->limit, 0.0);
  EXPECT_GT(failure.violation->value, 0.05);
  EXPECT_LT(failure.violation->value, 0.6);
  const std::string size = fmt::format("{:.1f} mm", 1e3 * failure.violation->value);
  EXPECT_NE(failure.message.find(size), std::string::npos) << failure.message;
}

TEST(OptimiseZmp, AMarginWiderThanTheSoleIsRefusedBeforeSolving) {
  const ZmpProblem problem = synthetic::Biped(2);
  const Result<OptimisedZmp> zmp = OptimiseZmp(problem, {.margin_m = 0.06}, PreferredZmp(problem));
  ASSERT_FALSE(zmp.ok());
  EXPECT_EQ(zmp.failure().code, FailureCode::kZmpSupport);
  ASSERT_TRUE(zmp.failure().violation);
  EXPECT_DOUBLE_EQ(zmp.failure().violation->value, 0.06);
  EXPECT_NEAR(zmp.failure().violation->at_s, problem.phases[1].start_s, 1e-9);
}

}  // namespace
}  // namespace gaitwright
