// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

#include "tests/planning/audit/good_plan.h"

namespace gaitwright {
namespace {

/// The violation at a place of a good plan with one change.
Violation ColumnViolation(const std::string& where, const std::function<void(MotionPlan&)>& change) {
  MotionPlan plan = GoodPlanOf("a1").plan;
  change(plan);
  const std::vector<Violation> found = ViolationsOf(GoodPlanOf("a1").model, plan);
  Violation violation = At(found, where);
  EXPECT_EQ(violation.law, Law::kConsistency);
  return violation;
}

TEST(AuditColumns, AQuaternionOfAnotherLengthIsFound) {
  const Violation found =
      ColumnViolation("quaternion norm", [](MotionPlan& plan) { plan.whole_body.q[7].segment<4>(3) *= 1.001; });
  EXPECT_NEAR(found.value, 1.001, 1e-9);
  EXPECT_EQ(found.limit, 1.0);
  EXPECT_NEAR(found.at_s, TimeOf(GoodPlanOf("a1").plan, 7), 1e-9);
}

TEST(AuditColumns, RowsOfTheCentreOfMassAreAsManyAsThoseOfTheBody) {
  const Violation found = ColumnViolation("centroidal rows", [](MotionPlan& plan) { plan.centroidal.p_WC.pop_back(); });
  EXPECT_EQ(found.value + 1.0, found.limit);
}

TEST(AuditColumns, SpeedsOfTheBaseAreHeldAgainstItsPlaces) {
  // A row that is 0.1 m/s too fast changes the mean over a step by half of that.
  const Violation moved =
      ColumnViolation("base position against velocity", [](MotionPlan& plan) { plan.whole_body.v[9].y() += 0.1; });
  EXPECT_NEAR(moved.value, 0.05, 0.005);
  EXPECT_EQ(moved.limit, 0.01);
  EXPECT_EQ(moved.unit, "m/s");
  const Violation turned =
      ColumnViolation("base rotation against velocity", [](MotionPlan& plan) { plan.whole_body.v[9][5] += 0.2; });
  EXPECT_NEAR(turned.value, 0.1, 0.01);
  EXPECT_EQ(turned.unit, "rad/s");
}

TEST(AuditColumns, AccelerationsOfTheBaseAreHeldAgainstItsSpeeds) {
  const Violation found =
      ColumnViolation("base velocity against acceleration", [](MotionPlan& plan) { plan.whole_body.a[9].z() += 8.0; });
  EXPECT_NEAR(found.value, 4.0, 0.1) << "half of it over each of two steps";
  EXPECT_EQ(found.limit, 1.0);
}

TEST(AuditColumns, EachJointIsHeldAgainstItsOwnSpeed) {
  const std::string& joint = GoodPlanOf("a1").model.dof_names[4];
  const Violation found = ColumnViolation(joint + " position against velocity",
                                          [](MotionPlan& plan) { plan.whole_body.v[9][6 + 4] += 0.3; });
  EXPECT_NEAR(found.value, 0.15, 0.01);
  EXPECT_EQ(found.limit, 0.02);
}

TEST(AuditColumns, ThePendulumsFrequencyMayBeOffByTwoPercent) {
  const MotionPlan& good = GoodPlanOf("a1").plan;
  const Violation found =
      ColumnViolation("frequency of the pendulum", [](MotionPlan& plan) { plan.centroidal.omega_rad_s *= 1.05; });
  EXPECT_NEAR(found.value, 1.05 * good.centroidal.omega_rad_s, 1e-9);
  EXPECT_NEAR(found.limit, good.centroidal.omega_rad_s, 0.02 * good.centroidal.omega_rad_s);
  MotionPlan slight = good;
  slight.centroidal.omega_rad_s *= 1.005;
  EXPECT_TRUE(ViolationsOf(GoodPlanOf("a1").model, slight).empty());
}

}  // namespace
}  // namespace gaitwright
