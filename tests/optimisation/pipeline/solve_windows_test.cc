// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "optimisation/pipeline/finish_motion_internal.h"
#include "optimisation/pipeline/solve_windows_internal.h"
#include "planning/audit/audit.h"
#include "planning/gait/find_gait.h"
#include "planning/plan/built_in_terrain.h"
#include "tests/named_robot.h"

namespace gaitwright {
namespace {

/// A trot of some seconds whose base is moved laterally, as no planner would.
MotionPlan Swaying(const RobotModel& model) {
  WalkCommand command;
  command.speed_m_s = 0.4;
  command.distance_m = 1.0;
  const Result<Gait> gait = FindGait(model, "trot", command.speed_m_s, {});
  EXPECT_TRUE(gait.ok());
  Result<PlannedMotion> planned = PlanMotion(model, FlatTerrain(0.8), *gait, command, {});
  EXPECT_TRUE(planned.ok()) << (planned.ok() ? "" : planned.failure().message);
  MotionPlan plan = std::move(planned->plan);
  for (int row = 0; row < plan.whole_body.size(); ++row) {
    const double share = row * plan.whole_body.step_s / plan.duration_s();
    plan.whole_body.q[static_cast<std::size_t>(row)].y() += 0.015 * std::pow(std::sin(3.0 * M_PI * share), 3.0);
  }
  return plan;
}

FollowOptions Windowed(double length_s, double overlap_s) {
  FollowOptions follow;
  follow.windows = {length_s, overlap_s};
  return follow;
}

double Farthest(const MotionPlan& a, const MotionPlan& b) {
  double farthest = 0.0;
  for (std::size_t k = 0; k < a.whole_body.q.size(); ++k)
    farthest = std::max(farthest, (a.whole_body.q[k] - b.whole_body.q[k]).cwiseAbs().maxCoeff());
  return farthest;
}

TEST(SolveWindows, JoinSmoothlyAndAreNearTheWholeSolve) {
  const RobotModel& model = NamedRobot("a1");
  const MotionPlan plan = Swaying(model);
  FollowReport one, many;
  const auto whole = FollowMotion(model, plan, {}, Windowed(60.0, 1.0), &one);
  FollowOptions windowed = Windowed(1.0, 0.6);
  int last_solve = 0, calls = 0;
  windowed.progress = [&](const FollowProgress& p) {
    EXPECT_LE(p.done, p.all);
    last_solve = p.solve;
    ++calls;
  };
  const auto parts = FollowMotion(model, plan, {}, windowed, &many);
  ASSERT_TRUE(whole.ok() && parts.ok()) << (parts.ok() ? "" : parts.failure().message);
  EXPECT_EQ(one.windows, 1);
  EXPECT_GE(many.windows, 3);
  EXPECT_EQ(last_solve, many.solves);
  EXPECT_GE(calls, many.windows * many.solves);
  EXPECT_LT(many.variables, one.variables);
  ASSERT_EQ(whole->whole_body.q.size(), parts->whole_body.q.size());
  EXPECT_LT(Farthest(*whole, *parts), 0.01);
  EXPECT_GT(Farthest(*whole, plan), 2.0 * Farthest(*whole, *parts)) << "the solves do not do anything";
  // Seams would break the check of consistency: it compares q, v and a between all rows.
  const auto audit = Audit(model, *parts, {});
  ASSERT_TRUE(audit.ok());
  EXPECT_TRUE(audit->pass()) << AuditText(*audit);
}

TEST(SolveWindows, TooShortAnOverlapDoesNotBreakThePlan) {
  const RobotModel& model = NamedRobot("a1");
  const MotionPlan plan = Swaying(model);
  const auto parts = FollowMotion(model, plan, {}, Windowed(0.8, 0.2));
  ASSERT_TRUE(parts.ok()) << parts.failure().message;
  const auto audit = Audit(model, *parts, {});
  ASSERT_TRUE(audit.ok());
  EXPECT_TRUE(audit->pass()) << AuditText(*audit);
}

BodyProblem Knots(int count) {
  BodyProblem problem;
  for (int k = 0; k < count; ++k) {
    problem.time_s.push_back(0.1 * k);
    BodyKnot knot;
    knot.reference.rate = VectorX::Constant(1, 1.0);
    problem.knots.push_back(knot);
  }
  return problem;
}

TEST(SolveWindows, SeamsAreWhereMostFeetPressAndTheMotionIsSlow) {
  BodyProblem problem = Knots(301);
  EXPECT_EQ(WindowsOf(problem, {20.0, 1.0}).size(), 1U) << "at most one and a half windows";
  problem.knots[147].pressing.resize(2);
  problem.knots[152].pressing.resize(2);
  problem.knots[152].reference.rate[0] = 0.1;
  const std::vector<KnotWindow> windows = WindowsOf(problem, {15.0, 1.0});
  ASSERT_EQ(windows.size(), 2U);
  EXPECT_EQ(windows[0].first, 0);
  EXPECT_EQ(windows[1].first, 152);
  EXPECT_EQ(windows[0].last, 162);
  EXPECT_EQ(windows[1].last, 300);
}

TEST(SolveWindows, AFailureNamesTheConstraint) {
  RobotModel weak = NamedRobot("a1");
  for (Joint& joint : weak.joints) {
    if (joint.name.find("calf") != std::string::npos) joint.effort_limit = 0.1;
  }
  const MotionPlan plan = Swaying(NamedRobot("a1"));
  FollowReport report;
  const auto parts = FollowMotion(weak, plan, {}, Windowed(1.0, 0.5), &report);
  ASSERT_FALSE(parts.ok());
  // All windows are solved, although the first one has no solution.
  ASSERT_FALSE(report.unmet_s.empty());
  EXPECT_TRUE(std::is_sorted(report.unmet_s.begin(), report.unmet_s.end()));
  EXPECT_LT(report.unmet_s.front(), plan.whole_body.start_s + 0.3 * plan.duration_s());
  EXPECT_GT(report.unmet_s.back(), plan.whole_body.start_s + 0.7 * plan.duration_s());
  EXPECT_NE(parts.failure().message.find("torque of '"), std::string::npos) << parts.failure().message;
}

}  // namespace
}  // namespace gaitwright
