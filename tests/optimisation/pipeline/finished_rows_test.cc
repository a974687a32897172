// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "optimisation/pipeline/finish_motion_internal.h"
#include "tests/named_robot.h"

namespace gaitwright {
namespace {

/// A robot that stands still, with the forces that hold it.
MotionPlan StillPlan(const RobotModel& model) {
  MotionPlan plan;
  plan.terrain.patches.emplace_back();
  plan.whole_body.step_s = 0.005;
  plan.whole_body.q.assign(21, StandingConfiguration(model));
  plan.whole_body.v.assign(21, VectorX::Zero(model.nv()));
  plan.whole_body.a = plan.whole_body.v;
  DynamicsScratch scratch(model);
  ForwardKinematics(model, plan.whole_body.q.front(), scratch);
  std::vector<std::vector<ContactInterval>> stays(model.feet.size(), {{0.0, 0.1}});
  plan.schedule = ScheduleFromIntervals(stays, 0.0, 0.1);
  for (int f = 0; f < static_cast<int>(model.feet.size()); ++f) {
    const Foot& foot = model.feet[static_cast<std::size_t>(f)];
    Foothold foothold{f, Pose::Identity(), Vector3::Zero(), 0, 0.0, 0.1};
    foothold.X_WF.translation() = FramePose(scratch, foot.body, foot.X_BF).translation();
    foothold.X_WF.translation().z() -= foot.radius;
    plan.footsteps.footholds.push_back(foothold);
  }
  return plan;
}

TEST(FinishedRows, MoveTheBaseAsForcesDo) {
  const RobotModel& model = NamedRobot("a1");
  MotionPlan plan = StillPlan(model);
  const std::vector<double> knots_s = KnotTimesOf(plan, 0.02);
  const BodyProblem problem = ProblemOf(model, plan, CoursesOf(model, plan), knots_s, {});
  const ChainSpline spline(knots_s);
  MatrixX values(model.nv(), spline.knots());
  for (int k = 0; k < spline.knots(); ++k) values.col(k) = problem.knots[static_cast<std::size_t>(k)].reference.x;
  const MatrixX points = spline.Through(values, VectorX::Zero(model.nv()), VectorX::Zero(model.nv()));
  // Less on a fore foot and more on a hind foot: the base pitches.
  std::vector<VectorX> forces = FirstForces(model, plan, problem);
  for (VectorX& at_knot : forces) {
    at_knot[2] -= 0.05;
    at_knot[at_knot.size() - 1] += 0.05;
  }
  SetRows(model, SolvedTrajectory(problem, points, forces), 0.005, plan);
  ASSERT_EQ(plan.whole_body.size(), 21);
  Vector3 force_W = Vector3::Zero();
  for (const ContactWrench& wrench : plan.whole_body.wrenches[10]) force_W += wrench.force_W;
  EXPECT_NEAR(force_W.z(), model.weight_n(), 1e-9 * model.weight_n());
  EXPECT_GT(std::abs(plan.whole_body.a[10][4]), 0.1);
  EXPECT_LT(plan.whole_body.a[10].tail(model.num_dofs()).norm(), 1e-9);
  const PlanResidual pitches = ResidualOf(model, plan);
  EXPECT_LT(pitches.force, 1e-3);
  for (auto& row : plan.whole_body.wrenches) row.assign(model.feet.size(), {});
  EXPECT_NEAR(ResidualOf(model, plan).force, 1.0, 2e-2);
}

TEST(FinishedRows, CentreOfMassAndItsZmpAreThoseOfTheBody) {
  const RobotModel& model = NamedRobot("a1");
  MotionPlan plan = StillPlan(model);
  SetCentroidal(model, plan);
  DynamicsScratch scratch(model);
  ForwardKinematics(model, plan.whole_body.q.front(), scratch);
  const Vector3 p_WC = CentreOfMass(model, scratch);
  ASSERT_EQ(plan.centroidal.size(), plan.whole_body.size());
  EXPECT_LT((plan.centroidal.p_WC[7] - p_WC).norm(), 1e-12);
  EXPECT_LT((plan.centroidal.p_WZ[7] - p_WC.head<2>()).norm(), 1e-9);
  EXPECT_LT(plan.centroidal.a_WC[7].norm(), 1e-9);
}

}  // namespace
}  // namespace gaitwright
