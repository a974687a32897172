// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/rigid_body_plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "kinematics/dynamics/dynamics.h"
#include "optimisation/centroidal/plan_over_terrain.h"
#include "planning/audit/audit.h"
#include "planning/plan/sample_plan.h"
#include "workflows/study/audited_motion.h"
#include "workflows/study/centroidal_bench.h"
#include "workflows/study/rigid_body_robot.h"

namespace gaitwright {
namespace {

/// A case of the set with its motion.
struct Solved {
  Terrain ground;
  PlanOverPatches plan;
};

Solved Solve(const std::string& name, const RigidBodyOptions& options = {}) {
  const Result<CentroidalProblemSet> set = LoadCentroidalProblems(CentroidalProblemsPath());
  const CentroidalCase one = CasesOf(*set, name).at(0);
  const CentroidalRobot& robot = set->robots[one.robot].second;
  Solved solved;
  solved.ground = WithFriction(set->grounds[one.ground], set->friction);
  const CentroidalTask task{set->distance_m, set->duration_s, set->friction};
  (void)PlanOverTerrain(solved.ground, CentroidalProblem(robot, robot.schedules[one.schedule], solved.ground, task), {},
                        options, {}, &solved.plan);
  return solved;
}

/// The laws that a report names.
std::vector<Law> LawsOf(const AuditReport& report) {
  std::vector<Law> laws;
  for (const Violation& v : report.violations) laws.push_back(v.law);
  return laws;
}

bool Names(const AuditReport& report, Law law) {
  const std::vector<Law> laws = LawsOf(report);
  return std::find(laws.begin(), laws.end(), law) != laws.end();
}

TEST(RigidBodyRobot, HasTheMassTheInertiaAndTheReachOfItsProblem) {
  for (const char* name : {"monoped-0-flat", "biped-0-flat", "anymal-1-flat"}) {
    const RigidBodyProblem problem = Solve(name).plan.choice.problem;
    const Result<RobotModel> robot = RigidBodyRobot(problem, name);
    ASSERT_TRUE(robot.ok()) << robot.failure().message;
    ASSERT_EQ(robot->feet.size(), problem.feet.size());
    EXPECT_NEAR(robot->total_mass_kg, problem.mass_kg, 1e-9);
    DynamicsScratch scratch(*robot);
    VectorX q = StandingConfiguration(*robot);
    ForwardKinematics(*robot, q, scratch);
    EXPECT_LT((CentreOfMass(*robot, scratch) - q.head<3>()).norm(), 1e-6);
    EXPECT_LT((LockedInertia(*robot, scratch) - problem.inertia_B).norm(), 1e-6);
    const std::vector<int> problem_foot = ProblemFeetOf(*robot, problem);
    // By the kinematics: feet are in the workspace with their slides at both ends, and out of it 1 mm beyond.
    for (std::size_t f = 0; f < problem.feet.size(); ++f) {
      const RigidFoot& foot = problem.feet[static_cast<std::size_t>(problem_foot[f])];
      const auto out = [&](const VectorX& at) {
        ForwardKinematics(*robot, at, scratch);
        const Vector3 p_B = FramePose(scratch, robot->feet[f].body, robot->feet[f].X_BF).translation() - at.head<3>();
        double most = -1.0;
        for (const WorkspaceSide& side : foot.workspace_B) most = std::max(most, side.normal.dot(p_B) - side.offset);
        return most;
      };
      for (const int joint : robot->legs[f].joints) {
        const int dof = robot->joints[static_cast<std::size_t>(joint)].dof;
        for (const double end : {robot->dof_lower(dof), robot->dof_upper(dof)}) {
          VectorX at = q;
          at[7 + dof] = end;
          EXPECT_NEAR(out(at), 0.0, 1e-9) << robot->dof_names[static_cast<std::size_t>(dof)];
          at[7 + dof] += end > 0.0 ? 1e-3 : -1e-3;
          EXPECT_NEAR(out(at), 1e-3, 1e-9);
        }
      }
    }
  }
}

TEST(RigidBodyRobot, RefusesWhatIsNoBox) {
  RigidBodyProblem problem = Solve("biped-0-flat").plan.choice.problem;
  problem.feet[0].workspace_B[0].normal = Vector3(1.0, 1.0, 0.0).normalized();
  EXPECT_THROW(RigidBodyTextsOf(problem, "tilted"), InvalidArgument);
  problem.feet[0].workspace_B.erase(problem.feet[0].workspace_B.begin());
  EXPECT_THROW(RigidBodyTextsOf(problem, "endless"), InvalidArgument);
}

TEST(RigidBodyPlan, MotionsOfTheSetPassAllLaws) {
  for (const char* name : {"monoped-0-flat", "biped-1-flat", "hyq-1-gap", "biped-1-slope"}) {
    const Solved solved = Solve(name);
    const Result<AuditReport> report =
        AuditRigidBody(solved.ground, solved.plan.choice.problem, solved.plan.plan.motion);
    ASSERT_TRUE(report.ok()) << name << " " << report.failure().message;
    EXPECT_TRUE(report->pass()) << name << "\n" << AuditText(*report);
    EXPECT_GT(report->samples, 2000);
  }
}

TEST(RigidBodyPlan, ABodyOnSolesPassesTooAndItsSolesAreHeldFlat) {
  const Result<CentroidalProblemSet> set = LoadCentroidalProblems(CentroidalProblemsPath());
  CentroidalRobot biped = set->robots[1].second;
  for (RigidFoot& foot : biped.feet)
    foot.contacts_F = {{-0.06, -0.03, 0.0}, {0.06, -0.03, 0.0}, {0.06, 0.03, 0.0}, {-0.06, 0.03, 0.0}};
  const Terrain& ground = set->grounds[0];
  const Result<PlanOverPatches> plan =
      PlanOverTerrain(ground, CentroidalProblem(biped, biped.schedules[0], ground, {1.0, 2.4, 0.5}));
  ASSERT_TRUE(plan.ok()) << plan.failure().message;
  const RigidBodyProblem& problem = plan->choice.problem;
  const Result<RobotModel> robot = RigidBodyRobot(problem, "soles");
  ASSERT_TRUE(robot.ok()) << robot.failure().message;
  EXPECT_EQ(robot->feet[0].type, FootType::kSole);
  EXPECT_EQ(robot->legs[0].joints.size(), 6U);
  const Result<AuditedMotion> motion = RefineByAudit(ground, *plan, {}, 6);
  ASSERT_TRUE(motion.ok()) << motion.failure().message;
  EXPECT_TRUE(motion->report.pass()) << AuditText(motion->report);
}

TEST(RigidBodyPlan, WhatIsBrokenOnPurposeIsNamed) {
  const Solved solved = Solve("hyq-1-flat");
  const RigidBodyProblem& problem = solved.plan.choice.problem;
  const Result<RobotModel> robot = RigidBodyRobot(problem, "hyq");
  ASSERT_TRUE(robot.ok());
  const Result<MotionPlan> plan = RigidBodyMotionPlan(*robot, solved.ground, problem, solved.plan.plan.motion);
  ASSERT_TRUE(plan.ok()) << plan.failure().message;
  ASSERT_TRUE(Audit(*robot, *plan, {})->pass());
  const auto broken = [&](const std::function<void(MotionPlan&)>& breaks) {
    MotionPlan other = *plan;
    breaks(other);
    return *Audit(*robot, other, {});
  };
  EXPECT_TRUE(Names(broken([](MotionPlan& p) {
                      for (auto& row : p.whole_body.wrenches) row[0].force_W *= 0.9;
                    }),
                    Law::kDynamics));
  EXPECT_TRUE(Names(broken([](MotionPlan& p) {
                      for (auto& row : p.whole_body.wrenches) row[0].force_W *= -1.0;
                    }),
                    Law::kUnilateral));
  EXPECT_TRUE(Names(broken([](MotionPlan& p) {
                      for (TerrainPatch& patch : p.terrain.patches) patch.friction = 0.05;
                    }),
                    Law::kFrictionCone));
  EXPECT_TRUE(
      Names(broken([](MotionPlan& p) { p.footsteps.footholds[5].X_WF.translation().x() += 0.05; }), Law::kConsistency));
  EXPECT_TRUE(
      Names(broken([](MotionPlan& p) { p.footsteps.footholds[5].X_WF.translation().x() += 1.5; }), Law::kReach));
  EXPECT_TRUE(
      Names(broken([](MotionPlan& p) { p.terrain.patches[0].X_WT.translation().z() += 0.02; }), Law::kFootClearance));
  EXPECT_TRUE(Names(broken([&](MotionPlan& p) {
                      for (VectorX& q : p.whole_body.q) q[2] += 0.15;
                    }),
                    Law::kConsistency));
}

TEST(RigidBodyPlan, RefusesARobotThatIsNotItsOwnAndMomentumInside) {
  const Solved one = Solve("biped-0-flat"), other = Solve("monoped-0-flat");
  const Result<RobotModel> robot = RigidBodyRobot(other.plan.choice.problem, "monoped");
  ASSERT_TRUE(robot.ok());
  const RigidBodyMotion& motion = one.plan.plan.motion;
  EXPECT_THROW((void)RigidBodyMotionPlan(*robot, one.ground, one.plan.choice.problem, motion), InvalidArgument);
  RigidBodyProblem inner = one.plan.choice.problem;
  inner.inner_momentum_W.assign(2, Vector3::Zero());
  inner.inner_torque_W.assign(2, Vector3::Zero());
  EXPECT_THROW((void)RigidBodyMotionPlan(*RigidBodyRobot(inner, "biped"), one.ground, inner, motion), InvalidArgument);
}

/// Swings over a ridge take the feet out of reach as the body was planned without them.
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

/// Onto a block of 0.5 m: no swing over its edge is within reach of the body as it was planned without swings.
TEST(AuditedMotion, SwingsOntoABlockArePlannedAlongWithTheBody) {
  const Solved solved = Solve("monoped-1-block");
  const AuditedMotion motion = *RefineByAudit(solved.ground, solved.plan, {}, 8);
  EXPECT_TRUE(Names(motion.first, Law::kJointPosition)) << AuditText(motion.first);
  EXPECT_TRUE(motion.report.pass()) << AuditText(motion.report) << motion.refusal;
  const RigidBodyProblem& problem = motion.choice.problem;
  ASSERT_FALSE(problem.swings.empty());
  ASSERT_EQ(motion.plan.motion.detours_W.size(), problem.swings.size());
  // By the problem's own words: the swing of the plan is within the workspace at shares that were not looked at.
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

/// Breaks four times farther apart, and no refinement of the planner's own.
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

}  // namespace
}  // namespace gaitwright
