// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "optimisation/whole_body/finish_problem_internal.h"
#include "tests/kinematics/made_robots.h"
#include "tests/optimisation/whole_body/stepping_plan.h"

namespace gaitwright {
namespace {

TEST(KnotTimes, AreAtAllChangesAndOnRows) {
  const RobotModel model = AnyRobot("a1");
  const MotionPlan plan = SteppingPlan(model);
  const std::vector<double> times = KnotTimesOf(plan, 0.01);
  for (const double change : {0.0, 0.1, 0.235, 0.4}) {
    EXPECT_TRUE(std::any_of(times.begin(), times.end(), [&](double t) { return std::abs(t - change) < 1e-12; }))
        << change;
  }
  for (std::size_t k = 0; k < times.size(); ++k) {
    EXPECT_NEAR(times[k] / 0.005, std::round(times[k] / 0.005), 1e-9);
    if (k == 0) continue;
    EXPECT_GT(times[k], times[k - 1]);
    EXPECT_LT(times[k] - times[k - 1], 0.0151);
  }
}

TEST(KnotTimes, AreDenserOverShortSwings) {
  const RobotModel model = AnyRobot("a1");
  const MotionPlan plan = SteppingPlan(model);
  const std::vector<double> times = KnotTimesOf(plan, 0.01, 24);
  double in_swing = 0.0, outside = 0.0;  // largest steps
  for (std::size_t k = 1; k < times.size(); ++k) {
    double& largest = times[k - 1] > 0.0999 && times[k] < 0.2351 ? in_swing : outside;
    largest = std::max(largest, times[k] - times[k - 1]);
  }
  EXPECT_NEAR(in_swing, 0.005, 1e-9) << "0.135 s over 24 are 5.6 ms, and knots are on rows";
  EXPECT_GT(outside, 0.0099);
  EXPECT_EQ(KnotTimesOf(plan, 0.01, 10), KnotTimesOf(plan, 0.01)) << "10 ms are enough for that";
}

TEST(ProblemOf, OnlyTheFrontEdgePressesAfterHeelOff) {
  const RobotModel model = AnyRobot("nao");
  MotionPlan plan = SteppingPlan(model);
  plan.footsteps.footholds[0].heel_off_s = 0.04;
  const std::vector<double> knots_s = KnotTimesOf(plan, 0.01);
  EXPECT_TRUE(std::any_of(knots_s.begin(), knots_s.end(), [](double t) { return std::abs(t - 0.04) < 1e-12; }));
  const BodyProblem problem = ProblemOf(model, plan, CoursesOf(model, plan), knots_s, {});
  for (std::size_t k = 0; k < knots_s.size(); ++k) {
    if (knots_s[k] > 0.0999) break;
    const std::vector<Vector3>& points = problem.knots[k].pressing.front().contact.points_F;
    const bool on_edge = knots_s[k] > 0.0399;
    EXPECT_EQ(points.size() == 2, on_edge) << knots_s[k];
    for (const Vector3& p_F : points) EXPECT_TRUE(!on_edge || p_F.x() > 0.0);
  }
}

TEST(ProblemOf, JointsThatStickStayExactlyWhereThePlanHoldsThem) {
  RobotModel model = AnyRobot("nao");
  for (Joint& joint : model.joints) joint.friction = 0.0;
  const int dof = model.joints.back().dof;
  MotionPlan plan = SteppingPlan(model);
  const std::vector<double> knots_s = KnotTimesOf(plan, 0.01);
  const auto stays = [&] { return ProblemOf(model, plan, CoursesOf(model, plan), knots_s, {}).StaysStill(dof); };
  EXPECT_FALSE(stays());
  model.joints.back().friction = 0.9 * model.dof_effort_limit(dof);
  EXPECT_TRUE(stays());
  plan.whole_body.q.back()[7 + dof] += 0.1;
  EXPECT_FALSE(stays()) << "the plan moves it";
}

TEST(FreeFootRows, OfAnkles) {
  using Rows = std::array<bool, 6>;
  const std::vector<Rows> of_ball = FreeFootRows(AnyRobot("a1"));
  for (const Rows& rows : of_ball) EXPECT_EQ(rows, (Rows{true, true, true, false, false, false}));
  // NAO's hips turn together, so that all twelve rows are there; without an ankle roll a line has no such row.
  const std::vector<Rows> of_line = FreeFootRows(AnyRobot("line"));
  for (const Rows& rows : of_line) EXPECT_FALSE(rows[3]);
  EXPECT_EQ(FreeFootRows(AnyRobot("nao"))[0], (Rows{true, true, true, true, true, true}));
}

TEST(ProblemOf, ASoleWithoutAnAnkleRollJointStaysFlatInStanceAndIsFreeToRollInSwings) {
  const RobotModel model = AnyRobot("line");
  const MotionPlan plan = SteppingPlan(model);
  const std::vector<double> knots_s = KnotTimesOf(plan, 0.01);
  const BodyProblem problem = ProblemOf(model, plan, CoursesOf(model, plan), knots_s, {});
  for (const BodyKnot& knot : problem.knots) {
    for (const FootGoal& goal : knot.feet) {
      EXPECT_EQ(goal.rows[3], !goal.swings);
      if (goal.swings) continue;
      EXPECT_GT(goal.above[3], 0.0);
      EXPECT_LT(goal.above[3], 2e-3) << "[rad]";
      EXPECT_EQ(goal.below, goal.above);
      for (const std::size_t i : {0u, 1u, 2u, 4u, 5u}) EXPECT_EQ(goal.above[i], 0.0);
    }
  }
  const RobotModel nao = AnyRobot("nao");
  const MotionPlan steps = SteppingPlan(nao);
  const BodyProblem rolled = ProblemOf(nao, steps, CoursesOf(nao, steps), knots_s, {});
  for (const FootGoal& goal : rolled.knots.front().feet)
    EXPECT_EQ(goal.above, (std::array<double, 6>{})) << "ankles roll these";
}

TEST(ProblemOf, PinsTheStartAndRestsAtTheEnd) {
  const RobotModel model = AnyRobot("a1");
  const MotionPlan plan = SteppingPlan(model);
  const std::vector<double> knots_s = KnotTimesOf(plan, 0.01);
  const BodyProblem problem = ProblemOf(model, plan, CoursesOf(model, plan), knots_s, {});
  ASSERT_EQ(problem.knots.size(), knots_s.size());
  EXPECT_TRUE(problem.knots.front().pins_place);
  EXPECT_TRUE(problem.knots.front().pins_motion);
  EXPECT_FALSE(problem.knots.back().pins_place);
  EXPECT_TRUE(problem.knots.back().pins_motion);
  EXPECT_EQ(problem.knots.front().pressing.size(), 4u);
  const std::vector<VectorX> forces = FirstForces(model, plan, problem);
  double weight = 0.0;
  for (Eigen::Index i = 2; i < forces.front().size(); i += 3) weight += forces.front()[i];
  EXPECT_NEAR(weight, 1.0, 1e-12);
}

}  // namespace
}  // namespace gaitwright
