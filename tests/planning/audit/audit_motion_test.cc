// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/planning/audit/good_plan.h"

namespace gaitwright {
namespace {

TEST(AuditMotion, ASoleThatIsTurnedFromItsFootholdIsFoundByItsAngle) {
  const GoodPlan& good = GoodPlanOf("nao");
  for (const double angle : {0.8e-3, 5e-3}) {
    MotionPlan plan = good.plan;
    Foothold& first = plan.footsteps.footholds.front();
    first.X_WF.linear() = first.X_WF.linear() * Eigen::AngleAxisd(angle, Vector3::UnitZ()).toRotationMatrix();
    const std::string where = good.model.feet[static_cast<std::size_t>(first.foot)].name + " rotated from its foothold";
    const std::vector<Violation> found = ViolationsOf(good.model, plan);
    const bool is_found = std::any_of(found.begin(), found.end(), [&](const Violation& v) { return v.where == where; });
    EXPECT_EQ(is_found, angle > 1e-3) << "a thousandth is let pass";
    if (is_found) {
      EXPECT_NEAR(At(found, where).value, angle, 2e-4);
    }
  }
}

TEST(AuditMotion, AFootOffItsFootholdIsFoundByItsDistance) {
  for (const char* robot : {"a1", "nao"}) {
    const GoodPlan& good = GoodPlanOf(robot);
    MotionPlan plan = good.plan;
    Foothold& first = plan.footsteps.footholds.front();
    first.X_WF.translation() += Vector3(3e-3, 4e-3, 0.0);
    const std::string where = good.model.feet[static_cast<std::size_t>(first.foot)].name + " off its foothold";
    const std::vector<Violation> found = ViolationsOf(good.model, plan);
    EXPECT_NEAR(At(found, where).value, 5e-3, 2e-4) << robot;
    EXPECT_EQ(At(found, where).unit, "m");
  }
}

TEST(AuditMotion, TheLeastHeightInMidSwingIsAMarginOfEachFoot) {
  const GoodPlan& good = GoodPlanOf("a1");
  AuditOptions options;
  options.margins = true;
  options.rate_hz = 200.0;
  const AuditReport report = Audit(good.model, good.plan, options).value();
  int feet = 0;
  for (const AuditMargin& margin : report.margins) {
    if (margin.law != Law::kFootClearance) continue;
    ++feet;
    EXPECT_GT(margin.value, 0.005) << margin.where;
    EXPECT_LT(margin.value, good.plan.swings.front().lift_m) << margin.where << ": lower than at half time";
    EXPECT_EQ(margin.limit, 0.0);
    EXPECT_DOUBLE_EQ(margin.margin, margin.value);
    EXPECT_FALSE(margin.share) << "of no limit there is no share";
  }
  EXPECT_EQ(feet, 4);
}

TEST(AuditMotion, ReachIsTheStraightLegAgainstTheFoothold) {
  const GoodPlan& good = GoodPlanOf("a1");
  MotionPlan plan = good.plan;
  Foothold& first = plan.footsteps.footholds.front();
  const double away_m = 2.0 * good.model.leg_length_m();
  first.X_WF.translation().x() += away_m;
  const Violation* reach = nullptr;
  const std::vector<Violation> found = ViolationsOf(good.model, plan);
  for (const Violation& violation : found) {
    if (violation.law == Law::kReach) reach = &violation;
  }
  ASSERT_NE(reach, nullptr);
  EXPECT_EQ(reach->where, good.model.feet[static_cast<std::size_t>(first.foot)].name);
  EXPECT_GT(reach->value, 0.9 * away_m);
  EXPECT_NEAR(reach->limit, good.model.legs[static_cast<std::size_t>(first.foot)].length_m,
              0.4 * good.model.leg_length_m());
}

}  // namespace
}  // namespace gaitwright
