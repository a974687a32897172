// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/centroidal/zmp_knots.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/optimisation/centroidal/walking_problem.h"

namespace gaitwright {
namespace {

/// Variables with which every knot is somewhere in its region, often at a corner.
VectorX AnyInside(const ZmpKnots& zmp, std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  VectorX x = VectorX::Zero(zmp.num_variables);
  for (const ZmpKnot& knot : zmp.knots) {
    if (knot.size == 0) continue;
    Vector2 p = Vector2::Zero();
    double sum = 0.0;
    for (const Vector2& corner : knot.region_W) {
      const double weight = std::pow(uniform(random), 8);
      p += weight * corner;
      sum += weight;
    }
    p /= sum;
    const MatrixX basis = knot.basis.leftCols(knot.size);
    x.segment(knot.first, knot.size) = (basis.transpose() * basis).inverse() * basis.transpose() * (p - knot.origin_W);
  }
  return x;
}

/// Smallest distance of the samples to the edge minus the required margin; not positive on a line.
double LeastMargin(const ZmpProblem& problem, const ZmpKnots& zmp, const VectorX& x) {
  const auto p_WZ = zmp.Sample(x);
  const auto margins = zmp.Margins();
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < p_WZ.size(); ++k) {
    const double t = problem.start_s + static_cast<double>(k) * problem.step_s;
    const Polygon region = RegionAt(problem.phases[ZmpPhaseAt(problem, t)], t);
    least = std::min(least, SignedDistance(region, p_WZ[k]) - (region.size() >= 3 ? margins[k] : 0.0));
  }
  return least;
}

TEST(ZmpKnots, WhateverTheyAreTheZmpStaysInItsSupports) {
  std::mt19937 random(3);
  for (const auto& problem : {synthetic::Biped(4), synthetic::Trot(8), synthetic::Trot(1)}) {
    for (const double margin_m : {0.0, 0.02}) {
      const Result<ZmpKnots> zmp = PlaceZmpKnots(problem, margin_m, 0.25);
      ASSERT_TRUE(zmp.ok()) << zmp.failure().message;
      ASSERT_EQ(zmp->samples.size(), static_cast<std::size_t>(problem.samples));
      for (int trial = 0; trial < 50; ++trial) {
        EXPECT_GT(LeastMargin(problem, *zmp, AnyInside(*zmp, random)), -1e-9);
      }
    }
  }
}

TEST(ZmpKnots, KnotsAreMetAndEndsAreGiven) {
  const ZmpProblem problem = synthetic::Trot(4);
  const Result<ZmpKnots> zmp = PlaceZmpKnots(problem, 0.0, 0.25);
  std::mt19937 random(5);
  const VectorX x = AnyInside(*zmp, random);
  const auto p_WZ = zmp->Sample(x);
  EXPECT_LT((p_WZ.front() - problem.phases.front().preferred_start).norm(), 1e-12);
  EXPECT_LT((p_WZ.back() - problem.phases.back().preferred_end).norm(), 1e-12);
  for (const ZmpKnot& knot : zmp->knots) {
    const double sample = (knot.time_s - problem.start_s) / problem.step_s;
    if (std::abs(sample - std::round(sample)) > 1e-6) continue;
    EXPECT_LT((p_WZ[static_cast<std::size_t>(std::lround(sample))] - knot.At(x)).norm(), 1e-9) << knot.time_s;
  }
}

TEST(ZmpKnots, AStanceOnALineHasThreeKnotsOfOneNumber) {
  const ZmpProblem problem = synthetic::Trot(3);
  const Result<ZmpKnots> zmp = PlaceZmpKnots(problem, 0.0, 0.25);
  for (const std::size_t phase : {std::size_t{1}, std::size_t{3}, std::size_t{5}}) {
    int count = 0;
    for (const ZmpKnot& knot : zmp->knots) {
      if (knot.phase != phase) continue;
      ++count;
      EXPECT_EQ(knot.size, 1);
    }
    EXPECT_EQ(count, 3);
  }
}

TEST(ZmpKnots, ASupportTooNarrowForTheMarginIsNamed) {
  const Result<ZmpKnots> zmp = PlaceZmpKnots(synthetic::Biped(2), 0.06, 0.25);
  ASSERT_FALSE(zmp.ok());
  EXPECT_EQ(zmp.failure().message, "in phase 1, the support at 0.80 s has no point 60.0 mm inside its edge");
}

}  // namespace
}  // namespace gaitwright
