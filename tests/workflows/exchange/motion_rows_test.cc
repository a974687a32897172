// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/exchange/motion_rows.h"

#include <gtest/gtest.h>

#include <cmath>

#include "kinematics/base/non_finite.h"
#include "optimisation/search/plan_walk.h"
#include "planning/plan/sample_plan.h"
#include "tests/named_robot.h"
#include "tests/workflows/exchange/quoted_walker.h"

namespace gaitwright {
namespace {

TEST(MotionRows, OfAPlanAreItsOwnRowsAtItsOwnRateAndInterpolatedBetween) {
  const QuotedWalker walker;
  const MotionRows own = RowsOfPlan(walker.model, walker.plan, UsualRate(walker.plan));
  ASSERT_EQ(own.size(), walker.plan.whole_body.size());
  for (int k = 0; k < own.size(); ++k) {
    const auto row = static_cast<std::size_t>(k);
    EXPECT_LT((own.q[row] - walker.plan.whole_body.q[row]).norm(), 1e-12);
    EXPECT_LT((own.tau[row] - walker.plan.whole_body.tau[row]).norm(), 1e-9);
  }
  const MotionRows fine = RowsOfPlan(walker.model, walker.plan, 1000.0);
  EXPECT_EQ(fine.size(), 5 * (own.size() - 1) + 1);
  WholeBodySample sample;
  SampleWholeBody(walker.plan.whole_body, fine.time_s[777], sample);
  EXPECT_TRUE(AreSame(fine.q[777], sample.q) && AreSame(fine.v[777], sample.v) && AreSame(fine.a[777], sample.a));
  EXPECT_GT((fine.q[777] - own.q[777 / 5]).norm(), 1e-6) << "between two nodes it is neither";
}

TEST(MotionRows, OfACycleEndWhereTheNextCycleBegins) {
  WalkRequest request;
  request.gait = "trot";
  request.gait_options.cycle_step_s = 0.005;
  request.command.distance_m = 1.5;
  request.command.speed_m_s = 0.4;
  const RobotModel& model = NamedRobot("a1");
  const Result<PlannedWalk> planned = PlanWalk(model, request);
  ASSERT_TRUE(planned.ok()) << planned.failure().message;
  const MotionPlan& plan = planned->motion.plan;
  const double cycle_s = plan.parts[0].gait.cycle_s;
  const CycleRows cycle = RowsOfCycle(model, plan, 60.0);
  const MotionRows& rows = cycle.rows;
  EXPECT_EQ(rows.size(), std::lround(60.0 * cycle_s) + 1);
  EXPECT_NEAR(cycle.rate_hz, (rows.size() - 1) / cycle_s, 1e-9);
  EXPECT_NEAR(rows.time_s.back() - rows.time_s.front(), cycle_s, 1e-9);
  EXPECT_LT((rows.q.front().tail(12) - rows.q.back().tail(12)).cwiseAbs().maxCoeff(), cycle.joints + 1e-9);
  EXPECT_LT(cycle.joints, 1e-3);
  EXPECT_NEAR(rows.q.back()[0] - rows.q.front()[0], 0.4 * cycle_s, 2e-3);
  EXPECT_EQ(rows.contact.front(), rows.contact.back());
  const QuotedWalker walker;
  EXPECT_THROW(RowsOfCycle(walker.model, walker.plan, 60.0), InvalidArgument) << "it takes one step";
}

TEST(MotionRows, AreEvenlySpacedAtRatesThatDoNotMeetTheEndToo) {
  const std::vector<double> before = TimesAtRate(1.0, 2.05, 10.0),
                            behind = TimesAtRate(1.0, 2.05, 10.0, LastTime::kBehindEnd);
  ASSERT_EQ(before.size(), 11U);
  EXPECT_EQ(before[3], 1.3);
  EXPECT_DOUBLE_EQ(before.back(), 2.0);
  ASSERT_EQ(behind.size(), 12U);
  EXPECT_DOUBLE_EQ(behind.back(), 2.1);
  for (const LastTime last : {LastTime::kBeforeEnd, LastTime::kBehindEnd})
    EXPECT_EQ(TimesAtRate(0.0, 0.3, 10.0, last).size(), 4U) << "no second row for the same end";
  EXPECT_EQ(RefusalText([] { TimesAtRate(0.0, 1.0, 0.0); }), "the rate is 0 Hz; accepted: 0.1 to 10000 Hz");
}

TEST(MotionRows, OfAPlanGoOnToRestBehindItsEndAndOfALogEndBeforeIt) {
  const QuotedWalker walker;  // lasts 2.7 s
  const MotionRows plan = RowsOfPlan(walker.model, walker.plan, 333.0),
                   log = RowsOfLog(walker.model, walker.log, 155.0);
  ASSERT_EQ(plan.size(), 901);
  ASSERT_EQ(log.size(), 419);
  EXPECT_NEAR(plan.time_s.back(), 900.0 / 333.0, 1e-12);
  EXPECT_NEAR(log.time_s.back(), 418.0 / 155.0, 1e-12);
  EXPECT_TRUE(AreSame(plan.q.back(), walker.plan.whole_body.q.back()));
  EXPECT_EQ(plan.v.back().norm(), 0.0);
  EXPECT_EQ(plan.contact.back(), walker.plan.schedule.phases.back().stance);
  for (const MotionRows* rows : {&plan, &log}) {
    const double step_s = rows->time_s[1] - rows->time_s[0];
    for (std::size_t k = 1; k < rows->time_s.size(); ++k)
      ASSERT_NEAR(rows->time_s[k] - rows->time_s[k - 1], step_s, 1e-9) << k;
  }
}

TEST(MotionRows, OfALogAreItsSamplesAndAreNotMadeDenser) {
  const QuotedWalker walker;
  const MotionRows own = RowsOfLog(walker.model, walker.log, 200.0);
  ASSERT_EQ(own.time_s.size(), walker.log.samples.size());
  EXPECT_TRUE(AreSame(own.q[100], walker.log.samples[100].q));
  EXPECT_EQ(own.contact[100], walker.log.samples[100].contact);
  EXPECT_TRUE(own.a.empty()) << "nothing measures accelerations";
  const MotionRows half = RowsOfLog(walker.model, walker.log, 100.0);
  EXPECT_TRUE(AreSame(half.q[50], walker.log.samples[100].q)) << "a sample that is met is not interpolated";
  const MotionRows odd = RowsOfLog(walker.model, walker.log, 160.0);
  const VectorX middle = 0.5 * (walker.log.samples[2].q + walker.log.samples[3].q);
  EXPECT_LT((odd.q[2] - middle).norm(), 1e-12) << "2 / 160 Hz is half way between samples 2 and 3";
  const std::string why = RefusalText([&] { RowsOfLog(walker.model, walker.log, 400.0); });
  EXPECT_TRUE(synthetic::Says(why, "400 Hz is above the log's rate of 200 Hz")) << why;
}

TEST(MotionRows, TheUsualRateIsAMultipleOfThePlansOwnFromTwoHundredUp) {
  const auto rate_of = [](double step_s) {
    MotionPlan plan;
    plan.whole_body.step_s = step_s;
    return UsualRate(plan);
  };
  EXPECT_EQ(rate_of(0.005), 200.0);
  EXPECT_EQ(rate_of(0.004), 250.0);
  EXPECT_EQ(rate_of(0.01), 200.0);
  EXPECT_EQ(rate_of(0.02), 200.0);
  EXPECT_NEAR(rate_of(0.007), 2.0 / 0.007, 1e-9);
  EXPECT_EQ(rate_of(1e-6), kHighestRate);
  EXPECT_EQ(rate_of(0.0), 200.0) << "a plan without rows";
}

TEST(MotionRows, BetweenRowsTheBaseTurnsInTheShortestDirection) {
  MotionRows rows;
  rows.time_s = {0.0, 1.0};
  VectorX q = VectorX::Zero(8);
  q.segment<4>(3) << 0.0, 0.0, std::sin(0.1), std::cos(0.1);  // rotated by 0.2 rad about z
  rows.q.push_back(q);
  q.segment<4>(3) << 0.0, 0.0, -std::sin(0.3), -std::cos(0.3);  // 0.6 rad, with the opposite sign of the quaternion
  rows.q.push_back(q);
  rows.v.assign(2, VectorX::Ones(7));
  RowSample sample;
  SampleRows(rows, 0.25, sample);
  EXPECT_NEAR(2.0 * std::atan2(sample.q[5], sample.q[6]), 0.3, 1e-12);
  EXPECT_NEAR(sample.q.segment<4>(3).norm(), 1.0, 1e-12);
}

TEST(MotionRows, BeyondTheEndsTheyRestAndWhatIsUnknownStaysSo) {
  MotionRows rows;
  rows.time_s = {1.0, 2.0};
  rows.q.assign(2, VectorX::Constant(8, 0.5));
  rows.v.assign(2, VectorX::Ones(7));
  for (VectorX& v : rows.v) v[3] = kNaN;
  RowSample sample;
  for (const double time_s : {0.5, 2.5}) {
    SampleRows(rows, time_s, sample);
    EXPECT_EQ(sample.v[0], 0.0) << time_s;
    EXPECT_TRUE(std::isnan(sample.v[3])) << time_s;
    EXPECT_EQ(sample.q[0], 0.5);
  }
  SampleRows(rows, 2.0, sample);
  EXPECT_EQ(sample.v[0], 1.0) << "the last row itself moves";
  EXPECT_EQ(sample.tau.size(), 0);
  EXPECT_EQ(sample.contact, 0U);
}

TEST(MotionRows, LogsOfAnotherRobotOrWithoutOrderAreRefused) {
  QuotedWalker walker;
  const auto refusal = [&] { return RefusalText([&] { RowsOfLog(walker.model, walker.log, 100.0); }); };
  std::swap(walker.log.samples[3].time_s, walker.log.samples[4].time_s);
  EXPECT_EQ(refusal(), "the log has a sample at 0.015 s after one at 0.02 s; times must increase");
  walker = QuotedWalker();
  walker.log.samples[0].q.conservativeResize(12);
  EXPECT_EQ(refusal(), "the log has 5 joints; robot 'block_biped' has 6");
  walker.log.samples.clear();
  EXPECT_EQ(refusal(), "the log has no sample");
}

}  // namespace
}  // namespace gaitwright
