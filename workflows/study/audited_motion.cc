// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/audited_motion.h"

#include <algorithm>
#include <cmath>

#include "optimisation/pipeline/refine_motion.h"
#include "optimisation/swing/free_swings.h"
#include "planning/audit/audit.h"
#include "workflows/study/rigid_body_plan.h"
#include "workflows/study/rigid_body_robot.h"

namespace gaitwright {
namespace {

/// Largest violation of a prismatic joint over its limit [m].
double StrayOf(const AuditReport& report) {
  double stray_m = 0.0;
  for (const Violation& v : report.violations) {
    if (v.law == Law::kJointPosition) stray_m = std::max(stray_m, std::abs(v.value - v.limit));
  }
  return stray_m;
}

}  // namespace

Result<AuditedMotion> RefineByAudit(const Terrain& ground, const PlanOverPatches& plan, RigidBodyOptions options,
                                    int most_rounds) {
  AuditedMotion audited;
  int audits = 0;
  const auto judge = [&](const PlanOverPatches& motion) -> Result<MotionVerdict> {
    const RigidBodyProblem& problem = motion.choice.problem;
    const Result<RobotModel> robot = RigidBodyRobot(problem, "rigid-body");
    if (!robot) return robot.failure();
    const Result<MotionPlan> made = RigidBodyMotionPlan(*robot, ground, problem, motion.plan.motion);
    if (!made) return made.failure();
    const Result<AuditReport> report = Audit(*robot, *made, {});
    if (!report) return report.failure();
    audited.report = *report;
    if (audits++ == 0) audited.first = *report;
    return MotionVerdict{report->pass(), StrayOf(*report),
                         FreeSwingsOf(ground, problem, made->swings, ProblemFeetOf(*robot, problem))};
  };
  RefineRules rules;
  rules.patches = RulesOf(ground, ChooseFootholdsOptions{}.edge_margin_m);
  rules.most_rounds = most_rounds;
  Result<RefinedMotion> refined = RefineMotion(ground, plan, std::move(options), rules, judge);
  if (!refined) return refined.failure();
  audited.choice = std::move(refined->motion.choice);
  audited.plan = std::move(refined->motion.plan);
  audited.refusal = refined->refusal;
  audited.swings_planned = refined->swings_planned;
  audited.halvings = refined->halvings;
  audited.changes = refined->changes;
  return audited;
}

}  // namespace gaitwright
