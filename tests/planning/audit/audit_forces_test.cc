// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kinematics/dynamics/foot_contact.h"
#include "tests/planning/audit/good_plan.h"

namespace gaitwright {
namespace {

/// Indices of the rows from `beside` rows before a row to as many after it.
std::vector<std::size_t> RowsAround(std::size_t row, std::size_t beside) {
  std::vector<std::size_t> rows;
  for (std::size_t k = row - beside; k <= row + beside; ++k) rows.push_back(k);
  return rows;
}

TEST(AuditForces, AFootThatPushesInItsSwingIsInconsistent) {
  for (const char* robot : {"a1", "nao"}) {
    const GoodPlan& good = GoodPlanOf(robot);
    MotionPlan plan = good.plan;
    const double push = 0.02 * good.model.weight_n();
    for (const std::size_t row : RowsAround(MidSwingRow(plan), 2)) plan.whole_body.wrenches[row][0].force_W.z() += push;
    const Violation found = At(ViolationsOf(good.model, plan), good.model.feet[0].name + " pushes in its swing");
    EXPECT_EQ(found.law, Law::kConsistency);
    EXPECT_NEAR(found.value, push, 1e-6 * good.model.weight_n());
    EXPECT_EQ(found.unit, "N");
    EXPECT_NEAR(found.at_s, TimeOf(plan, MidSwingRow(plan)), 3.0 * plan.whole_body.step_s);
  }
}

TEST(AuditForces, ACentreOfPressureOutsideOfTheSoleIsFoundByHowFar) {
  const GoodPlan& good = GoodPlanOf("nao");
  MotionPlan plan = good.plan;
  // In the middle of foot 0's swing, the whole weight is on foot 1. Its centre of pressure is moved 0.3 m forward.
  const std::size_t row = MidSwingRow(plan);
  for (const std::size_t k : RowsAround(row, 1)) {
    ContactWrench& wrench = plan.whole_body.wrenches[k][1];
    wrench.moment_W.y() -= 0.3 * wrench.force_W.z();
  }
  const Violation found = At(ViolationsOf(good.model, plan), good.model.feet[1].name + " centre of pressure outside");
  EXPECT_EQ(found.law, Law::kUnilateral);
  EXPECT_GT(found.value, 0.15);
  EXPECT_LT(found.value, 0.3);
  EXPECT_EQ(found.unit, "m");
}

/// Feet that press against each other along the line between them do not load the body, only their legs.
TEST(AuditForces, FeetThatPressAgainstEachOtherLoadTheirLegsAlone) {
  const GoodPlan& good = GoodPlanOf("a1");
  MotionPlan plan = good.plan;
  const std::size_t row = 20;
  ASSERT_EQ(plan.schedule.phases.front().stance, AllFeet(4));
  ASSERT_LT(TimeOf(plan, row + 2), plan.schedule.phases.front().end_s);
  const Moment moment(good.model, plan, TimeOf(plan, row));
  const Vector3 from = ContactFrame(good.model, moment.scratch, 0).translation();
  const Vector3 to = ContactFrame(good.model, moment.scratch, 3).translation();
  const Vector3 squeeze = 0.1 * good.model.weight_n() * (to - from).normalized();
  for (const std::size_t k : RowsAround(row, 2)) {
    plan.whole_body.wrenches[k][0].force_W += squeeze;
    plan.whole_body.wrenches[k][3].force_W -= squeeze;
  }
  const std::vector<Violation> found = ViolationsOf(good.model, plan);
  ASSERT_FALSE(found.empty());
  for (const Violation& violation : found) {
    EXPECT_EQ(violation.law, Law::kDynamics) << violation.where;
    const bool of_legs = std::any_of(good.model.legs.begin(), good.model.legs.end(), [&](const Leg& leg) {
      if (leg.foot != 0 && leg.foot != 3) return false;
      return std::any_of(leg.joints.begin(), leg.joints.end(), [&](int joint) {
        return good.model.joints[static_cast<std::size_t>(joint)].name == violation.where;
      });
    });
    EXPECT_TRUE(of_legs) << violation.where;
  }
}

TEST(AuditForces, AForceThatNothingNeedsIsMissingFromTheBaseAsItIs) {
  const GoodPlan& good = GoodPlanOf("a1");
  MotionPlan plan = good.plan;
  const double push = 0.1 * good.model.weight_n();
  for (const std::size_t k : RowsAround(20, 2)) plan.whole_body.wrenches[k][1].force_W.z() += push;
  const Violation found = At(ViolationsOf(good.model, plan), "base force");
  EXPECT_EQ(found.law, Law::kDynamics);
  EXPECT_NEAR(found.value, push, 0.01 * push);
  EXPECT_NEAR(found.limit, 0.02 * good.model.weight_n(), 1e-9);
}

}  // namespace
}  // namespace gaitwright
