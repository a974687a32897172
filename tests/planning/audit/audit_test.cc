// SPDX-License-Identifier: BSD-3-Clause
#include "planning/audit/audit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "tests/planning/audit/good_plan.h"

namespace gaitwright {
namespace {

/// The failure of the audit for a good plan with one change.
Failure MisfitOf(const std::function<void(MotionPlan&)>& change) {
  const GoodPlan& good = GoodPlanOf("a1");
  MotionPlan plan = good.plan;
  change(plan);
  const Result<AuditReport> report = Audit(good.model, plan, {});
  EXPECT_FALSE(report.ok());
  return report.ok() ? Failure{} : report.failure();
}

TEST(AuditOfPlans, RowsThatAreNotTheRobotsAreAMisfitWithTheirColumn) {
  struct Case {
    std::function<void(WholeBodyTrajectory&)> change;
    std::string says;
  };
  const std::vector<Case> cases = {{[](auto& w) { w.q[3].conservativeResize(5); }, "its q has 5 numbers"},
                                   {[](auto& w) { w.v[0].conservativeResize(4); }, "its v has 4 numbers"},
                                   {[](auto& w) { w.a.back().conservativeResize(3); }, "its a has 3 numbers"},
                                   {[](auto& w) { w.tau[1].conservativeResize(2); }, "its tau has 2 numbers"},
                                   {[](auto& w) { w.v.pop_back(); }, "rows of v"},
                                   {[](auto& w) { w.wrenches.pop_back(); }, "rows of contact wrenches"},
                                   {[](auto& w) { w.wrenches[2].resize(3); }, "it has 3 feet"},
                                   {[](auto& w) { w.step_s = 0.0; }, "more than 0 is needed"},
                                   {[](auto& w) { w.step_s = 1e5; }, "at most 3600 s"}};
  for (const Case& c : cases) {
    const Failure failure = MisfitOf([&](MotionPlan& plan) { c.change(plan.whole_body); });
    EXPECT_EQ(failure.kind, FailureKind::kBadInput);
    EXPECT_EQ(failure.code, FailureCode::kMisfit);
    EXPECT_NE(failure.message.find(c.says), std::string::npos) << failure.message;
  }
}

TEST(AuditOfPlans, AScheduleThatCannotBeIsAMisfit) {
  EXPECT_EQ(MisfitOf([](MotionPlan& plan) { plan.schedule.phases.clear(); }).code, FailureCode::kMisfit);
  EXPECT_EQ(MisfitOf([](MotionPlan& plan) { plan.schedule.phases[0].stance |= FootBit(9); }).code,
            FailureCode::kMisfit);
  EXPECT_EQ(MisfitOf([](MotionPlan& plan) { plan.schedule.phases[0].end_s += 0.01; }).code, FailureCode::kMisfit);
}

TEST(AuditOfPlans, SamplesAreTheDurationTimesTheRateAndOneMore) {
  const GoodPlan& good = GoodPlanOf("a1");
  for (const double rate_hz : {50.0, 200.0}) {
    AuditOptions options;
    options.rate_hz = rate_hz;
    const AuditReport report = Audit(good.model, good.plan, options).value();
    EXPECT_EQ(report.samples, 1 + static_cast<int>(std::floor(good.plan.duration_s() * rate_hz + 1e-6)));
    EXPECT_EQ(report.rate_hz, rate_hz);
    EXPECT_TRUE(report.pass()) << AuditText(report);
  }
}

TEST(AuditOfPlans, MarginsAreGivenOnlyWhereAskedAndAreNotNegativeOfAGoodPlan) {
  const GoodPlan& good = GoodPlanOf("a1");
  AuditOptions options;
  options.rate_hz = 100.0;
  EXPECT_TRUE(Audit(good.model, good.plan, options)->margins.empty());
  options.margins = true;
  const AuditReport report = Audit(good.model, good.plan, options).value();
  EXPECT_GT(report.margins.size(), 20U);
  for (const AuditMargin& margin : report.margins) EXPECT_GE(margin.margin, -1e-3) << margin.where;
  for (std::size_t i = 1; i < report.margins.size(); ++i)
    EXPECT_LE(static_cast<int>(report.margins[i - 1].law), static_cast<int>(report.margins[i].law));
}

TEST(AuditOfPlans, AValueThatIsNoNumberIsInconsistent) {
  const GoodPlan& good = GoodPlanOf("a1");
  MotionPlan plan = good.plan;
  plan.whole_body.tau[plan.whole_body.tau.size() / 2][0] = std::nan("");
  AuditOptions options;
  options.rate_hz = 200.0;
  const AuditReport report = Audit(good.model, plan, options).value();
  ASSERT_FALSE(report.pass());
  EXPECT_EQ(report.violations.front().law, Law::kConsistency);
  EXPECT_TRUE(std::any_of(report.violations.begin(), report.violations.end(),
                          [](const Violation& v) { return v.where == "value is not finite" && std::isnan(v.value); }));
}

TEST(AuditOfPlans, ViolationsComeInTheOrderOfTheLaws) {
  const GoodPlan& good = GoodPlanOf("a1");
  RobotModel weak = good.model;
  for (Joint& joint : weak.joints) {
    joint.effort_limit *= 0.1;
    joint.velocity_limit *= 0.1;
    joint.effort_limit_is_placeholder = joint.velocity_limit_is_placeholder = false;
  }
  AuditOptions options;
  options.rate_hz = 200.0;
  const AuditReport report = Audit(weak, good.plan, options).value();
  ASSERT_GT(report.violations.size(), 4U);
  for (std::size_t i = 1; i < report.violations.size(); ++i) {
    const Violation &before = report.violations[i - 1], &after = report.violations[i];
    EXPECT_LE(static_cast<int>(before.law), static_cast<int>(after.law));
    if (before.law != after.law) continue;
    EXPECT_GE(std::abs(before.value - before.limit), std::abs(after.value - after.limit)) << "the worst first";
    EXPECT_NE(before.where, after.where) << "each place once";
  }
}

TEST(AuditOfPlans, APlaceholderIsNotedAndNeverBroken) {
  const GoodPlan& good = GoodPlanOf("a1");
  RobotModel unknown = good.model;
  for (Joint& joint : unknown.joints) {
    joint.effort_limit = joint.velocity_limit = 1e-3;
    joint.effort_limit_is_placeholder = joint.velocity_limit_is_placeholder = true;
  }
  AuditOptions options;
  options.rate_hz = 100.0;
  const AuditReport report = Audit(unknown, good.plan, options).value();
  EXPECT_TRUE(report.pass()) << AuditText(report);
  const std::string& name = unknown.joints.front().name;
  for (const std::string kind : {"torque", "speed"}) {
    const std::string note = "joint '" + name + "': its " + kind + " limit is a placeholder";
    EXPECT_NE(std::find(report.notes.begin(), report.notes.end(), note), report.notes.end()) << note;
  }
}

TEST(AuditOfPlans, ALinkWhoseMeshIsMissingIsNoted) {
  const GoodPlan& good = GoodPlanOf("a1");
  RobotModel model = good.model;
  model.missing_meshes = {{"some_link", "its mesh 'x.stl' is not there"}};
  AuditOptions options;
  options.rate_hz = 50.0;
  const AuditReport report = Audit(model, good.plan, options).value();
  EXPECT_TRUE(std::any_of(report.notes.begin(), report.notes.end(), [](const std::string& note) {
    return note.find("'some_link'") != std::string::npos && note.find("x.stl") != std::string::npos;
  }));
}

}  // namespace
}  // namespace gaitwright
