// SPDX-License-Identifier: BSD-3-Clause
#include "planning/audit/findings.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/planning/audit/good_plan.h"

namespace gaitwright {
namespace {

TEST(Findings, CountSamplesOnceForAllPlaces) {
  Findings findings;
  findings.SetSamples(10.0, 100.0, 400);
  for (int k = 0; k < 400; ++k) {
    const double at_s = 10.0 + 0.01 * k;
    if (k < 50 || k >= 320) findings.Note(Law::kJointTorque, "knee", at_s, 2.0, 1.0, "N m");
    if (k < 20) findings.Note(Law::kJointTorque, "hip", at_s, 2.0, 1.0, "N m");
    if (k == 150) findings.Note(Law::kConsistency, "columns", at_s, 2.0, 1.0, "1");
  }
  const std::vector<BrokenTime> broken = findings.Broken();
  ASSERT_EQ(broken.size(), 2U);
  EXPECT_EQ(broken[0].law, Law::kConsistency) << "in the order of the checks";
  EXPECT_NEAR(broken[0].share, 1.0 / 400.0, 1e-12);
  EXPECT_EQ(broken[0].worst_s, std::vector<double>{11.0});
  EXPECT_EQ(broken[1].law, Law::kJointTorque);
  EXPECT_NEAR(broken[1].share, 130.0 / 400.0, 1e-12);
  EXPECT_EQ(broken[1].worst_s, (std::vector<double>{13.0, 10.0})) << "the longest first";
  ASSERT_EQ(broken[1].spans.size(), 2U) << "one for consecutive samples";
  EXPECT_NEAR(broken[1].spans[0].start_s, 10.0, 1e-9);
  EXPECT_NEAR(broken[1].spans[0].end_s, 10.5, 1e-9);
  EXPECT_NEAR(broken[1].spans[1].start_s, 13.2, 1e-9);
  EXPECT_NEAR(broken[1].spans[1].end_s, 14.0, 1e-9);
  EXPECT_EQ(BrokenText(broken),
            "  consistency        fails in 0.2 % of the time, longest from 11 to 12 s\n"
            "  joint_torque       fails in 32.5 % of the time, longest from 13 to 14 s, 10 to 11 s\n");
}

TEST(Findings, ListAtMostThreeSeconds) {
  Findings findings;
  findings.SetSamples(0.0, 10.0, 100);
  for (int k = 0; k < 100; ++k) findings.Note(Law::kReach, "foot", 0.1 * k, 2.0, 1.0, "m");
  const std::vector<BrokenTime> broken = findings.Broken();
  ASSERT_EQ(broken.size(), 1U);
  EXPECT_EQ(broken[0].worst_s, (std::vector<double>{0.0, 1.0, 2.0}));
  EXPECT_EQ(broken[0].share, 1.0) << "never more, by rounding";
}

TEST(Findings, BelongToTheAudit) {
  const GoodPlan& good = GoodPlanOf("a1");
  std::vector<BrokenTime> broken;
  const auto sound = AuditOverTime(good.model, good.plan, {}, broken);
  ASSERT_TRUE(sound.ok());
  EXPECT_TRUE(sound->pass());
  EXPECT_TRUE(broken.empty());
  MotionPlan plan = good.plan;
  const std::size_t half = plan.whole_body.tau.size() / 2;
  for (std::size_t k = 0; k < half; ++k) plan.whole_body.tau[k][0] += 1000.0;
  const auto wrong = AuditOverTime(good.model, plan, {}, broken);
  ASSERT_TRUE(wrong.ok());
  EXPECT_EQ(wrong->violations, Audit(good.model, plan, {})->violations);
  EXPECT_EQ(LawsOf(wrong->violations).size(), broken.size());
  const auto torque =
      std::find_if(broken.begin(), broken.end(), [](const BrokenTime& one) { return one.law == Law::kJointTorque; });
  ASSERT_NE(torque, broken.end());
  EXPECT_NEAR(torque->share, 0.5, 0.02);
}

}  // namespace
}  // namespace gaitwright
