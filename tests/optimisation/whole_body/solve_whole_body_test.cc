// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/whole_body/solve_whole_body.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/spatial/rotation.h"
#include "kinematics/trajectory/swing_curve.h"
#include "planning/plan/sample_plan.h"
#include "tests/named_robot.h"
#include "tests/optimisation/whole_body/standing_problem.h"

namespace gaitwright {
namespace {

Result<WholeBodySolution> SolvedStanding(const StandingProblem& standing, const WholeBodyProblem& problem,
                                         double* unreached_s = nullptr) {
  const std::vector<Vector3> no_roll(standing.footsteps.footholds.size(), Vector3::Zero());
  return SolveWholeBody(standing.model, problem, no_roll, {}, unreached_s);
}

/// The centre of mass sways to the left and back with this amplitude, twice a second, and down by half of it.
void SwayBy(double sway_m, StandingProblem& standing) {
  constexpr double kRate = 4.0 * M_PI;  // [rad/s]
  const Vector3 by = sway_m * Vector3(0.0, 0.5, -0.25);
  for (int k = 0; k < standing.centroidal.size(); ++k) {
    const auto i = static_cast<std::size_t>(k);
    const double angle = kRate * k * standing.centroidal.step_s;
    standing.centroidal.p_WC[i] += (1.0 - std::cos(angle)) * by;
    standing.centroidal.v_WC[i] = kRate * std::sin(angle) * by;
    standing.centroidal.a_WC[i] = kRate * kRate * std::cos(angle) * by;
  }
}

class SolveWholeBodyTest : public testing::TestWithParam<const char*> {};

TEST_P(SolveWholeBodyTest, StandingStillIsTheStandingPosture) {
  const StandingProblem standing(NamedRobot(GetParam()), 3);
  const Result<WholeBodySolution> solution = SolvedStanding(standing, standing.Problem());
  ASSERT_TRUE(solution.ok()) << solution.failure().message;
  const WholeBodyTrajectory& motion = solution->trajectory;
  ASSERT_EQ(motion.size(), 3);
  EXPECT_DOUBLE_EQ(motion.step_s, standing.centroidal.step_s);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_LT((motion.q[k] - StandingConfiguration(standing.model)).norm(), 1e-3);
    EXPECT_LT(motion.v[k].norm() + motion.a[k].norm(), 1e-9);
  }
}

TEST_P(SolveWholeBodyTest, TheCentreOfMassIsWhereThePlanHasItAndFeetStay) {
  StandingProblem standing(NamedRobot(GetParam()), 41);
  SwayBy(0.02, standing);
  const Result<WholeBodySolution> solution = SolvedStanding(standing, standing.Problem());
  ASSERT_TRUE(solution.ok()) << solution.failure().message;
  DynamicsScratch scratch(standing.model);
  double moved = 0.0;
  for (std::size_t k = 0; k < 41; ++k) {
    ForwardKinematics(standing.model, solution->trajectory.q[k], scratch);
    EXPECT_LT((CentreOfMass(standing.model, scratch) - standing.centroidal.p_WC[k]).norm(), 1e-8);
    moved = std::max(moved, (standing.centroidal.p_WC[k] - standing.centroidal.p_WC[0]).norm());
    for (std::size_t f = 0; f < standing.model.legs.size(); ++f) {
      const double above = ContactFrame(standing.model, scratch, static_cast<int>(f)).translation().z();
      EXPECT_NEAR(above, 0.0, 1e-6) << standing.model.feet[f].name;
    }
  }
  EXPECT_GT(moved, 0.01);
}

TEST_P(SolveWholeBodyTest, SpeedsAndAccelerationsAreDerivativesOfPositions) {
  StandingProblem standing(NamedRobot(GetParam()), 41);
  SwayBy(0.02, standing);
  const Result<WholeBodySolution> solution = SolvedStanding(standing, standing.Problem());
  ASSERT_TRUE(solution.ok()) << solution.failure().message;
  const WholeBodyTrajectory& w = solution->trajectory;
  const Eigen::Index n = standing.model.num_dofs();
  const double two_steps = 2.0 * w.step_s;
  double fastest = 0.0, strongest = 0.0, v_off = 0.0, a_off = 0.0;
  for (std::size_t k = 1; k + 1 < w.q.size(); ++k) {
    fastest = std::max(fastest, w.v[k].tail(n).norm());
    strongest = std::max(strongest, w.a[k].norm());
    v_off = std::max(v_off, ((w.q[k + 1] - w.q[k - 1]).tail(n) / two_steps - w.v[k].tail(n)).norm());
    a_off = std::max(a_off, ((w.v[k + 1] - w.v[k - 1]) / two_steps - w.a[k]).norm());
  }
  EXPECT_GT(fastest, 0.1);
  EXPECT_LT(v_off, 0.01 * fastest);
  EXPECT_LT(a_off, 0.01 * strongest);
}

TEST_P(SolveWholeBodyTest, AFootIsWhereItHasRolledTo) {
  StandingProblem standing(NamedRobot(GetParam()), 26);  // to the far end of the sway
  SwayBy(0.03, standing);
  const Result<WholeBodySolution> solution = SolvedStanding(standing, standing.Problem());
  ASSERT_TRUE(solution.ok()) << solution.failure().message;
  for (std::size_t f = 0; f < standing.model.legs.size(); ++f) {
    const std::vector<Vector3>& contact_W = solution->contact_W[f];
    const Vector3 moved = contact_W.back() - contact_W.front();
    EXPECT_LT((moved - solution->roll_at_liftoff_W[f]).norm(), 1e-8);
    EXPECT_LT(solution->roll_at_touchdown_W[f].norm(), 1e-12);
    if (standing.model.feet[f].radius > 0.0) {
      EXPECT_GT(moved.norm(), 1e-4) << "a ball rolls";
    } else {
      EXPECT_LT(moved.norm(), 1e-8) << "a sole stays";
    }
  }
}

TEST_P(SolveWholeBodyTest, ACentreOfMassOutOfReachIsRefusedAtItsTime) {
  StandingProblem standing(NamedRobot(GetParam()), 9);
  for (std::size_t k = 6; k < 9; ++k) standing.centroidal.p_WC[k].z() += 2.0;
  double unreached_s = -1.0;
  const Result<WholeBodySolution> solution = SolvedStanding(standing, standing.Problem(), &unreached_s);
  ASSERT_FALSE(solution.ok());
  EXPECT_EQ(solution.failure().kind, FailureKind::kInfeasible);
  EXPECT_EQ(solution.failure().code, FailureCode::kOutOfReach);
  EXPECT_EQ(solution.failure().stage, "SolveWholeBody");
  EXPECT_TRUE(solution.failure().message.starts_with("at 0.030 s: ")) << solution.failure().message;
  EXPECT_NEAR(unreached_s, 0.03, 1e-12);
  EXPECT_FALSE(SolvedStanding(standing, standing.Problem()).ok()) << "without a place for the time";
}

INSTANTIATE_TEST_SUITE_P(Robots, SolveWholeBodyTest, testing::Values("a1", "nao"));

TEST(SolveWholeBody, TheBaseIsTurnedFromItsStandingAttitude) {
  const StandingProblem standing(NamedRobot("a1"), 2);
  WholeBodyProblem problem = standing.Problem();
  const Motion1 yaw{0.1, 0.0, 0.0}, pitch{-0.06, 0.0, 0.0}, roll{0.04, 0.0, 0.0};
  problem.turning = [&](double) { return TurningOf(yaw, pitch, roll); };
  const Result<WholeBodySolution> solution = SolvedStanding(standing, problem);
  ASSERT_TRUE(solution.ok()) << solution.failure().message;
  const Matrix3 standing_R = BaseRotation(StandingConfiguration(standing.model));
  const Matrix3 turned = BaseRotation(solution->trajectory.q[1]) * standing_R.transpose();
  EXPECT_LT(RotationLog(turned.transpose() * TurningOf(yaw, pitch, roll).R_WB).norm(), 1e-8);
}

TEST(SolveWholeBody, JointsThatNoTaskTakesAreHeldAsAsked) {
  const StandingProblem standing(NamedRobot("nao"), 3);
  const RobotModel& model = standing.model;
  const Eigen::Index head = model.DofIndex("HeadYaw");
  WholeBodyProblem problem = standing.Problem();
  problem.posture = [&](double time_s, PostureTarget& posture) {
    posture.q = model.standing_joints;
    posture.v = posture.a = VectorX::Zero(model.num_dofs());
    posture.q[head] = 0.2 + 3.0 * time_s;
    posture.v[head] = 3.0;
  };
  const Result<WholeBodySolution> solution = SolvedStanding(standing, problem);
  ASSERT_TRUE(solution.ok()) << solution.failure().message;
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(solution->trajectory.q[k][7 + head], 0.2 + 0.015 * static_cast<double>(k), 1e-9);
    EXPECT_NEAR(solution->trajectory.v[k][6 + head], 3.0, 1e-9);
  }
}

TEST(SolveWholeBody, ASwingFootFollowsItsCurveToItsNextFoothold) {
  StandingProblem standing(NamedRobot("a1"), 41);  // 0.2 s
  const double up_s = 0.05, down_s = 0.15;
  std::vector<std::vector<ContactInterval>> stays(standing.model.feet.size());
  for (std::size_t f = 1; f < 4; ++f) stays[f] = {{0.0, standing.end_s()}};
  stays[0] = {{0.0, up_s}, {down_s, standing.end_s()}};
  standing.schedule = ScheduleFromIntervals(stays, 0.0, standing.end_s());
  Foothold from = standing.footsteps.footholds[0], to = from;
  from.liftoff_s = up_s;
  to.touchdown_s = down_s;
  to.X_WF.translation().x() += 0.03;
  standing.footsteps.footholds[0] = from;
  standing.footsteps.footholds.push_back(to);
  standing.swings = {{0, up_s, down_s, from.X_WF, to.X_WF, 0.04}};
  // The swing must aim short of its foothold by the sphere's roll at touch-down.
  std::vector<Vector3> expected(5, Vector3::Zero());
  Result<WholeBodySolution> solution = SolveWholeBody(standing.model, standing.Problem(), expected, {});
  for (int pass = 0; pass < 4 && solution; ++pass) {
    expected = solution->roll_at_touchdown_W;
    solution = SolveWholeBody(standing.model, standing.Problem(), expected, {});
  }
  ASSERT_TRUE(solution.ok()) << solution.failure().message;
  EXPECT_GT(expected[4].norm(), 1e-4);
  EXPECT_LT((solution->contact_W[0][30] - to.X_WF.translation()).norm(), 1e-6);
  EXPECT_LT((solution->contact_W[0][9] - from.X_WF.translation()).norm(), 1e-4);
  const double lift_m = Evaluate(CurveOf(standing.swings[0]), 0.1).X_WF.translation().z();
  EXPECT_NEAR(solution->contact_W[0][20].z(), lift_m, 1e-6);
  EXPECT_EQ(solution->trajectory.wrenches[20][0].force_W.norm(), 0.0) << "in the air";
}

}  // namespace
}  // namespace gaitwright
