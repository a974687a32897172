// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/centroidal/zmp_problem.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/kinematics/drawn.h"
#include "tests/optimisation/centroidal/walking_problem.h"

namespace gaitwright {
namespace {

std::vector<Vector2> AnyZmp(const ZmpProblem& problem, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-0.2, 0.2);
  std::vector<Vector2> p_WZ;
  for (int k = 0; k < problem.samples; ++k) p_WZ.push_back(Drawn<Vector2>(uniform, random));
  return p_WZ;
}

TEST(PendulumMotion, HoldsStillOverItsZmp) {
  ZmpProblem problem = synthetic::Biped(2);
  problem.start_W = problem.end_W = Vector2(0.03, -0.02);
  const auto motion =
      PendulumMotion(problem, std::vector<Vector2>(static_cast<std::size_t>(problem.samples), problem.start_W));
  for (int k = 0; k < motion.size(); ++k) {
    const auto i = static_cast<std::size_t>(k);
    EXPECT_LT((motion.p_WC[i].head<2>() - problem.start_W).norm() + motion.v_WC[i].norm() + motion.a_WC[i].norm(),
              1e-12);
  }
}

TEST(PendulumMotion, ObeysThePendulum) {
  ZmpProblem problem = synthetic::Biped(2);
  for (std::size_t k = 0; k < problem.zmp_offset.size(); ++k)
    problem.zmp_offset[k] = Vector2(0.01 * std::sin(0.02 * static_cast<double>(k)), 0.0);
  const auto p_WZ = AnyZmp(problem, 1);
  const auto motion = PendulumMotion(problem, p_WZ);
  const double h = problem.step_s, w2 = problem.omega_rad_s * problem.omega_rad_s;
  for (std::size_t k = 0; k + 1 < p_WZ.size(); ++k) {
    const Vector2 a = w2 * (motion.p_WC[k].head<2>() - p_WZ[k] + problem.zmp_offset[k]);
    EXPECT_LT((motion.a_WC[k].head<2>() - a).norm(), 1e-9);
    // The acceleration is nearly linear in a step: the corrected trapezoidal rule is exact to the third order.
    const Vector3 moved = h * motion.v_WC[k] + h * h / 6.0 * (2.0 * motion.a_WC[k] + motion.a_WC[k + 1]);
    EXPECT_LT((motion.p_WC[k + 1] - motion.p_WC[k] - moved).norm(), 1e-7);
    const Vector3 gained = 0.5 * h * (motion.a_WC[k] + motion.a_WC[k + 1]);
    EXPECT_LT((motion.v_WC[k + 1] - motion.v_WC[k] - gained).norm(), 1e-5);
  }
}

TEST(RespondAtEnds, IsHowPendulumMotionEnds) {
  for (const auto& base : {synthetic::Biped(3), synthetic::Trot(5)}) {
    ZmpProblem problem = base;
    problem.start_W = Vector2(0.02, -0.05);
    for (Vector2& d : problem.zmp_offset) d = Vector2(0.003, -0.001);
    const auto p_WZ = AnyZmp(problem, 7);
    const auto motion = PendulumMotion(problem, p_WZ);
    const EndResponse response = RespondAtEnds(problem);
    Vector2 dcm = response.dcm_start_by_end * problem.end_W;
    Vector2 com = response.com_end_by_start * problem.start_W + response.com_end_by_end * problem.end_W;
    for (std::size_t k = 0; k < p_WZ.size(); ++k) {
      dcm += response.dcm_start[k] * (p_WZ[k] - problem.zmp_offset[k]);
      com += response.com_end[k] * (p_WZ[k] - problem.zmp_offset[k]);
    }
    const Vector2 expected = problem.start_W + motion.v_WC.front().head<2>() / problem.omega_rad_s;
    ASSERT_GT((dcm - problem.start_W).norm(), 1e-3);
    EXPECT_LT((dcm - expected).norm(), 1e-12);
    EXPECT_LT((com - motion.p_WC.back().head<2>()).norm(), 1e-12);
  }
}

}  // namespace
}  // namespace gaitwright
