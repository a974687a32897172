// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/centroidal/preview_zmp.h"

#include <gtest/gtest.h>

#include "optimisation/centroidal/centre_of_mass.h"
#include "tests/optimisation/centroidal/walking_problem.h"

namespace gaitwright {
namespace {

TEST(PreviewZmp, StaysInItsSupportsNearItsReference) {
  for (const auto& problem : {synthetic::Biped(5, 0.25, 2.4), synthetic::Trot(8)}) {
    const auto reference = PreviewReference(problem, 1.6);
    const auto p_WZ = PreviewZmp(problem, {});
    ASSERT_EQ(p_WZ.size(), static_cast<std::size_t>(problem.samples));
    double off = 0.0;
    for (std::size_t k = 0; k < p_WZ.size(); ++k) {
      const double t = problem.start_s + static_cast<double>(k) * problem.step_s;
      EXPECT_GT(SignedDistance(RegionAt(problem.phases[ZmpPhaseAt(problem, t)], t), p_WZ[k]), -1e-9) << t;
      off = std::max(off, (p_WZ[k] - reference[k]).norm());
    }
    EXPECT_GT(off, 1e-6);
    EXPECT_LT(off, 0.015);
  }
}

TEST(PreviewZmp, TheReferenceStandsStillForAPreview) {
  const ZmpProblem problem = synthetic::Biped(5, 0.25, 2.4);
  const auto reference = PreviewReference(problem, 1.6);
  for (std::size_t k = 0; k <= 320; ++k) {
    EXPECT_LT((reference[k] - problem.start_W).norm(), 1e-12);
    EXPECT_LT((reference[reference.size() - 1 - k] - problem.end_W).norm(), 1e-12);
  }
  EXPECT_GT((reference[400] - problem.start_W).norm(), 0.01);
}

TEST(PreviewZmp, ThePendulumStartsAndEndsAtRest) {
  const ZmpProblem problem = synthetic::Biped(5, 0.25, 2.4);
  const Result<CentreOfMassPlan> plan = PlanCentreOfMass(problem, {.method = "preview"});
  ASSERT_TRUE(plan.ok()) << plan.failure().message;
  const CentroidalTrajectory& motion = plan->trajectory;
  EXPECT_LT(motion.v_WC.front().norm() + motion.a_WC.front().norm(), 1e-4);
  EXPECT_LT(motion.v_WC.back().norm() + motion.a_WC.back().norm(), 1e-4);
  EXPECT_LT((motion.p_WC.back().head<2>() - problem.end_W).norm(), 1e-9);
}

}  // namespace
}  // namespace gaitwright
