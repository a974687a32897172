// SPDX-License-Identifier: BSD-3-Clause
#include "planning/plan/sample_plan.h"

#include <gtest/gtest.h>

#include "tests/planning/audit/good_plan.h"

namespace gaitwright {
namespace {

/// A plan cut out of a walk, so that it moves at both ends.
WholeBodyTrajectory MidWalk() {
  const MotionPlan& plan = GoodPlanOf("a1").plan;
  const WholeBodyTrajectory& w = plan.whole_body;
  const auto from = static_cast<std::ptrdiff_t>(MidSwingRow(plan)), to = from + 20;
  WholeBodyTrajectory cut;
  cut.start_s = w.start_s + static_cast<double>(from) * w.step_s;
  cut.step_s = w.step_s;
  cut.q.assign(w.q.begin() + from, w.q.begin() + to);
  cut.v.assign(w.v.begin() + from, w.v.begin() + to);
  cut.a.assign(w.a.begin() + from, w.a.begin() + to);
  cut.tau.assign(w.tau.begin() + from, w.tau.begin() + to);
  cut.wrenches.assign(w.wrenches.begin() + from, w.wrenches.begin() + to);
  return cut;
}

TEST(SampleWholeBody, GoesThroughItsNodesTheEndsIncluded) {
  const WholeBodyTrajectory w = MidWalk();
  WholeBodySample sample;
  for (const int k : {0, 1, 7, w.size() - 2, w.size() - 1}) {
    const auto i = static_cast<std::size_t>(k);
    SampleWholeBody(w, w.start_s + k * w.step_s, sample);
    EXPECT_GT(w.v[i].norm(), 0.1);
    EXPECT_LT((sample.q - w.q[i]).norm(), 1e-9) << k;
    EXPECT_LT((sample.v - w.v[i]).norm(), 1e-6) << k;
    EXPECT_LT((sample.a - w.a[i]).norm(), 1e-3) << k;
    EXPECT_LT((sample.tau - w.tau[i]).norm(), 1e-6) << k;
  }
}

TEST(SampleWholeBody, IsAtRestBeyondItsEnds) {
  const WholeBodyTrajectory w = MidWalk();
  WholeBodySample sample;
  for (const bool late : {false, true}) {
    SampleWholeBody(w, late ? w.end_s() + 0.1 : w.start_s - 0.1, sample);
    EXPECT_EQ(sample.v.norm() + sample.a.norm(), 0.0);
    EXPECT_EQ(sample.q, late ? w.q.back() : w.q.front());
    EXPECT_EQ(sample.tau, late ? w.tau.back() : w.tau.front());
  }
}

TEST(SampleWholeBody, RatesAreDerivativesBetweenNodes) {
  const WholeBodyTrajectory w = MidWalk();
  constexpr double kStep = 1e-6;
  WholeBodySample before, at, after;
  const Eigen::Index n = w.tau[0].size();
  for (const double place : {0.3, 5.6, 17.9}) {
    const double t = w.start_s + place * w.step_s;
    SampleWholeBody(w, t - kStep, before);
    SampleWholeBody(w, t, at);
    SampleWholeBody(w, t + kStep, after);
    EXPECT_LT(((after.q - before.q).tail(n) / (2.0 * kStep) - at.v.tail(n)).norm(), 1e-5) << place;
    EXPECT_LT(((after.v - before.v).tail(n) / (2.0 * kStep) - at.a.tail(n)).norm(), 1e-3) << place;
  }
}

TEST(SampleCentroidal, GoesThroughItsNodesTheEndsIncluded) {
  CentroidalTrajectory c = GoodPlanOf("a1").plan.centroidal;
  const std::size_t row = MidSwingRow(GoodPlanOf("a1").plan);
  for (std::vector<Vector3>* column : {&c.p_WC, &c.v_WC, &c.a_WC}) column->resize(row + 1);
  c.p_WZ.resize(row + 1);
  EXPECT_GT(c.v_WC.back().norm(), 0.1);
  const double end_s = c.start_s + static_cast<double>(row) * c.step_s;
  EXPECT_LT((SampleCentroidal(c, end_s).v_WC - c.v_WC.back()).norm(), 1e-9);
  EXPECT_LT((SampleCentroidal(c, end_s).a_WC - c.a_WC.back()).norm(), 1e-6);
  EXPECT_EQ(SampleCentroidal(c, end_s + 0.1).v_WC.norm(), 0.0);
}

TEST(FootholdAt, IsTheLastThatHasTouchedDown) {
  const MotionPlan& plan = GoodPlanOf("a1").plan;
  const auto& footholds = plan.footsteps.footholds;
  for (int foot = 0; foot < 5; ++foot) {
    for (double t = -0.5; t < plan.whole_body.end_s() + 0.5; t += 0.0173) {
      int expected = -1;
      for (int i = 0; i < static_cast<int>(footholds.size()); ++i) {
        const Foothold& foothold = footholds[static_cast<std::size_t>(i)];
        if (foothold.foot == foot && (expected < 0 || foothold.touchdown_s <= t)) expected = i;
      }
      EXPECT_EQ(FootholdAt(plan.footsteps, foot, t), expected) << foot << " at " << t;
    }
  }
}

}  // namespace
}  // namespace gaitwright
