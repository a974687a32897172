// SPDX-License-Identifier: BSD-3-Clause
#include "playback/score/plan_state.h"

#include <gtest/gtest.h>

#include "kinematics/base/result.h"
#include "tests/playback/synthetic.h"

namespace gaitwright {
namespace {

TEST(PlanState, GivesRowsBackAndACubicInBetween) {
  WholeBodyTrajectory motion;
  motion.step_s = 0.1;
  motion.start_s = 1.0;
  const auto cubic = [](double t) { return t * t * t - 2.0 * t; };
  for (int k = 0; k < 4; ++k) {
    const double t = 0.1 * k;
    VectorX q(8), v(7);
    q << cubic(t), 0, 0, 0, 0, std::sin(0.1 * t), std::cos(0.1 * t), cubic(t);
    v << 3.0 * t * t - 2.0, 0, 0, 0, 0, 0.2, 3.0 * t * t - 2.0;
    motion.q.push_back(q);
    motion.v.push_back(v);
    motion.a.push_back(VectorX::Constant(7, t));
    motion.tau.push_back(VectorX::Constant(1, t));
  }
  EXPECT_EQ(PlanStateAt(motion, 1.2).q, motion.q[2]);
  const PlanState between = PlanStateAt(motion, 1.234);
  EXPECT_NEAR(between.q[0], cubic(0.234), 1e-12);
  EXPECT_NEAR(between.q[7], cubic(0.234), 1e-12);
  EXPECT_NEAR(between.q[5], std::sin(0.0234), 1e-12);
  EXPECT_NEAR(between.a[0], 0.234, 1e-12);
  EXPECT_EQ(PlanStateAt(motion, -5.0).q, motion.q.front());
  EXPECT_EQ(PlanStateAt(motion, 50.0).q, motion.q.back());
  EXPECT_THROW(PlanStateAt(WholeBodyTrajectory{}, 0.0), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
