// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/rigid_body_plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "kinematics/dynamics/dynamics.h"
#include "optimisation/centroidal/plan_over_terrain.h"
#include "planning/audit/audit.h"
#include "planning/plan/sample_plan.h"
#include "tests/workflows/study/solved_case.h"
#include "workflows/study/audited_motion.h"
#include "workflows/study/centroidal_bench.h"
#include "workflows/study/rigid_body_robot.h"

namespace gaitwright {
namespace {

using solved_case::Names, solved_case::Solve, solved_case::Solved;

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
    // By the kinematics: feet are in the workspace with their prismatic joints at both ends, and outside 1 mm beyond.
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
  const auto broken = [&](const std::function<void(MotionPlan&)>& change) {
    MotionPlan other = *plan;
    change(other);
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
  inner.leg_momentum_W.assign(2, Vector3::Zero());
  inner.leg_torque_W.assign(2, Vector3::Zero());
  EXPECT_THROW((void)RigidBodyMotionPlan(*RigidBodyRobot(inner, "biped"), one.ground, inner, motion), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
