// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/audited_motion.h"

#include <gtest/gtest.h>

#include "kinematics/trajectory/swing_curve.h"
#include "planning/audit/audit.h"
#include "planning/plan/sample_plan.h"
#include "tests/workflows/study/solved_case.h"
#include "workflows/study/rigid_body_plan.h"
#include "workflows/study/rigid_body_robot.h"

namespace gaitwright {
namespace {

using solved_case::LawsOf, solved_case::Names, solved_case::Solve, solved_case::Solved;

/// If the body is planned without swings, swings over a ridge are out of reach.
TEST(AuditedMotion, FeetInTheAirAreBroughtWithinReach) {
  const Solved solved = Solve("hyq-0-slope");
  const auto refined = [&](int rounds) { return *RefineByAudit(solved.ground, solved.plan, {}, rounds); };
  const AuditedMotion before = refined(0), after = refined(6);
  EXPECT_TRUE(Names(before.report, Law::kJointPosition)) << AuditText(before.report);
  EXPECT_TRUE(after.report.pass()) << AuditText(after.report);
  EXPECT_EQ(LawsOf(after.first), LawsOf(before.report));
  EXPECT_GE(after.swings_planned, 1);
  EXPECT_FALSE(after.choice.problem.swings.empty());
}

/// On a block of 0.5 m no swing over its edge is within reach if the body is planned without swings.
TEST(AuditedMotion, SwingsOntoABlockArePlannedAlongWithTheBody) {
  const Solved solved = Solve("monoped-1-block");
  const AuditedMotion motion = *RefineByAudit(solved.ground, solved.plan, {}, 8);
  EXPECT_TRUE(Names(motion.first, Law::kJointPosition)) << AuditText(motion.first);
  EXPECT_TRUE(motion.report.pass()) << AuditText(motion.report) << motion.refusal;
  const RigidBodyProblem& problem = motion.choice.problem;
  ASSERT_FALSE(problem.swings.empty());
  ASSERT_EQ(motion.plan.motion.detours_W.size(), problem.swings.size());
  // Independent check: the swing of the plan is within the problem's workspace at points that the planner did not
  // check.
  const RobotModel robot = *RigidBodyRobot(problem, "monoped");
  const MotionPlan plan = *RigidBodyMotionPlan(robot, solved.ground, problem, motion.plan.motion);
  ASSERT_EQ(plan.swings.size(), problem.swings.size());
  EXPECT_EQ(plan.swings[0].detour_W, motion.plan.motion.detours_W[0]);
  const std::vector<RigidBodySample> samples = Sample(motion.plan.motion, 1e-3);
  for (const SwingTrajectory& swing : plan.swings) {
    for (const RigidBodySample& sample : samples) {
      if (sample.time_s <= swing.start_s || sample.time_s >= swing.end_s) continue;
      const Vector3 p_B = RotationOf(sample.angles_rad).transpose() *
                          (Evaluate(CurveOf(swing), sample.time_s).X_WF.translation() - sample.p_WC);
      for (const WorkspaceSide& side : problem.feet[0].workspace_B) EXPECT_LT(side.normal.dot(p_B), side.offset);
    }
  }
}

/// Nodes four times farther apart, without the planner's own refinement.
TEST(AuditedMotion, CoarseNodesFailTheAuditAndAreRefinedUntilItPasses) {
  RigidBodyOptions coarse;
  coarse.spacing_s *= 4.0;
  coarse.least_intervals = 2;
  coarse.max_refinements = 0;
  coarse.fault_tolerance = 1.0;
  for (const char* name : {"biped-2-flat", "biped-3-flat", "anymal-3-flat", "hyq-1-gap"}) {
    const Solved solved = Solve(name, coarse);
    const Result<AuditedMotion> motion = RefineByAudit(solved.ground, solved.plan, coarse, 6);
    ASSERT_TRUE(motion.ok()) << name << " " << motion.failure().message;
    EXPECT_TRUE(Names(motion->first, Law::kJointPosition)) << name;
    EXPECT_GT(motion->first.violations.at(0).at_s, 0.0);
    EXPECT_TRUE(motion->report.pass()) << name << "\n" << AuditText(motion->report) << motion->refusal;
    EXPECT_GE(motion->halvings, 1) << name;
  }
}

TEST(AuditedMotion, AMotionThatPassesIsLeftAsItIs) {
  const Solved solved = Solve("monoped-0-flat");
  const Result<AuditedMotion> motion = RefineByAudit(solved.ground, solved.plan, {}, 6);
  ASSERT_TRUE(motion.ok()) << motion.failure().message;
  ASSERT_TRUE(motion->report.pass()) << AuditText(motion->report);
  EXPECT_EQ(motion->swings_planned + motion->halvings + motion->changes, 0);
  EXPECT_EQ(motion->refusal, "");
  EXPECT_EQ(motion->plan.numbers.x, solved.plan.plan.numbers.x);
}

}  // namespace
}  // namespace gaitwright
