// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "tests/playback/played.h"
#include "workflows/words/plan_tasks_internal.h"

namespace gaitwright::tasks {
namespace {

TEST(PostureWithin, TheLargestSizeIsFoundToAThirtiethOfTheFirst) {
  for (const double limit : {0.05, 0.37, 0.61, 0.99}) {
    int asked = 0;
    const double found = LargestBelow(
        [&](double size) {
          ++asked;
          return size <= limit;
        },
        1.0);
    EXPECT_LE(found, limit);
    EXPECT_GE(found, limit - 1.0 / 30.0);
    EXPECT_LE(asked, 5) << "each is a plan and an audit";
  }
  EXPECT_EQ(LargestBelow([](double) { return false; }, 1.0), 0.0);
  EXPECT_NEAR(LargestBelow([](double size) { return size <= 0.2; }, 0.4), 0.2, 0.4 / 30.0) << "it scales";
}

TEST(PostureWithin, StayingOnHoldsTheLastRowAtRest) {
  const synthetic::Played stood = synthetic::Stood();
  MotionPlan plan = stood.plan;
  const auto rows = static_cast<std::size_t>(plan.whole_body.size());
  plan.centroidal.step_s = plan.whole_body.step_s;
  plan.centroidal.p_WC.assign(rows, Vector3(0.0, 0.0, 0.5));
  plan.centroidal.v_WC.assign(rows, Vector3::Ones());
  plan.centroidal.a_WC.assign(rows, Vector3::Ones());
  plan.centroidal.p_WZ.assign(rows, Vector2::Zero());
  plan.parts.front().gait = StandingGait(2);
  plan.whole_body.v.back().setOnes();
  const double end_s = plan.whole_body.end_s();
  StayOn(0.5, plan);
  EXPECT_NEAR(plan.whole_body.end_s(), end_s + 0.5, 1e-9);
  EXPECT_EQ(plan.whole_body.q.back(), stood.plan.whole_body.q.back());
  EXPECT_EQ(plan.whole_body.tau.back(), stood.plan.whole_body.tau.back());
  EXPECT_TRUE(plan.whole_body.v.back().isZero() && plan.whole_body.a.back().isZero());
  EXPECT_TRUE(plan.centroidal.v_WC.back().isZero() && plan.centroidal.a_WC.back().isZero());
  for (const std::size_t size : {plan.whole_body.v.size(), plan.whole_body.a.size(), plan.whole_body.wrenches.size(),
                                 plan.centroidal.p_WC.size(), plan.centroidal.p_WZ.size()})
    EXPECT_EQ(size, plan.whole_body.q.size());
}

TEST(PostureWithin, StayingOnLengthensThePhaseAndItsFootholdsAndAddsAPart) {
  MotionPlan plan = synthetic::Stood().plan;
  plan.parts.front().gait = StandingGait(2);
  plan.centroidal = {};
  plan.centroidal.p_WC = {Vector3::Zero()};
  plan.centroidal.p_WZ = {Vector2::Zero()};
  const double end_s = plan.whole_body.end_s();
  StayOn(0.25, plan);
  EXPECT_NEAR(plan.schedule.phases.back().end_s, end_s + 0.25, 1e-9);
  for (const Foothold& foothold : plan.footsteps.footholds) EXPECT_NEAR(foothold.liftoff_s, end_s + 0.25, 1e-9);
  ASSERT_EQ(plan.parts.size(), 2U);
  EXPECT_NEAR(plan.parts.back().start_s, end_s, 1e-9);
  EXPECT_NEAR(plan.parts.back().end_s, end_s + 0.25, 1e-9);
  EXPECT_EQ(plan.parts.back().gait.num_feet(), 2);
  StayOn(0.0, plan);
  EXPECT_NEAR(plan.whole_body.end_s(), end_s + 0.25 + plan.whole_body.step_s, 1e-9) << "a row at least";
}

}  // namespace
}  // namespace gaitwright::tasks
