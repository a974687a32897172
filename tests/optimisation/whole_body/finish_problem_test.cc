// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "optimisation/whole_body/finish_problem_internal.h"
#include "planning/plan/heel_off_internal.h"
#include "tests/kinematics/made_robots.h"

namespace gaitwright {
namespace {

/// One foot stands, swings from 0.1 s to 0.235 s, and stands until 0.4 s; all others stand.
MotionPlan SteppingPlan(const RobotModel& model) {
  MotionPlan plan;
  plan.whole_body.step_s = 0.005;
  plan.whole_body.q.assign(81, StandingConfiguration(model));
  plan.whole_body.v.assign(81, VectorX::Zero(model.nv()));
  plan.whole_body.a = plan.whole_body.v;
  plan.terrain.patches.emplace_back();
  std::vector<std::vector<ContactInterval>> stays(model.feet.size(), {{0.0, 0.4}});
  stays[0] = {{0.0, 0.1}, {0.235, 0.4}};
  plan.schedule = ScheduleFromIntervals(stays, 0.0, 0.4);
  for (int foot = 0; foot < static_cast<int>(model.feet.size()); ++foot) {
    for (const ContactInterval& stay : stays[static_cast<std::size_t>(foot)])
      plan.footsteps.footholds.push_back({foot, Pose::Identity(), Vector3::Zero(), 0, stay.start_s, stay.end_s});
  }
  plan.footsteps.footholds[1].X_WF.translation().x() = 0.1;
  SwingTrajectory swing;
  swing.start_s = 0.1;
  swing.end_s = 0.235;
  swing.X_WF_end = plan.footsteps.footholds[1].X_WF;
  swing.lift_m = 0.05;
  plan.swings.push_back(swing);
  return plan;
}

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

TEST(FootCourse, FootThatLandsOrLeavesBearsNoLoad) {
  const RobotModel model = AnyRobot("a1");
  const MotionPlan plan = SteppingPlan(model);
  const FootCourse course(model, plan, 0);
  EXPECT_TRUE(course.At(0.0).presses);
  EXPECT_TRUE(course.At(0.095).presses);
  for (const double end : {0.1, 0.235}) {
    EXPECT_FALSE(course.At(end).presses) << end;
    EXPECT_FALSE(course.At(end).swings) << end;
  }
  EXPECT_TRUE(course.At(0.15).swings);
  EXPECT_FALSE(course.At(0.15).presses);
  EXPECT_TRUE(course.At(0.24).presses);
  EXPECT_TRUE(course.At(0.4).presses);
  EXPECT_NEAR(course.At(0.4).X_WF.translation().x(), 0.1, 1e-12);
  EXPECT_GT(course.At(0.1675).X_WF.translation().z(), 0.04);
}

TEST(FootCourse, ASoleTurnsAboutItsFrontEdgeAfterHeelOff) {
  const RobotModel model = AnyRobot("nao");
  const Foot& foot = model.feet[0];
  MotionPlan plan = SteppingPlan(model);
  plan.footsteps.footholds[0].heel_off_s = 0.04;
  plan.swings[0].X_WF_start = TurnedAboutEdge(foot, plan.footsteps.footholds[0].X_WF, 0.3);
  const FootCourse course(model, plan, 0);
  const auto turn_at = [&](double time_s) {
    return EdgeTurnOf(foot, plan.footsteps.footholds[0].X_WF, course.At(time_s).X_WF);
  };
  double before_rad = 0.0;
  for (double t = 0.045; t < 0.0999; t += 0.005) {
    EXPECT_TRUE(course.At(t).on_edge);
    EXPECT_TRUE(course.At(t).presses);
    EXPECT_LT(turn_at(t).off_m + turn_at(t).turned_rad, 1e-9);
    EXPECT_GT(turn_at(t).pitch_rad, before_rad);
    before_rad = turn_at(t).pitch_rad;
  }
  EXPECT_FALSE(course.At(0.035).on_edge);
  EXPECT_EQ(turn_at(0.035).pitch_rad, 0.0);
  EXPECT_NEAR(turn_at(0.1).pitch_rad, 0.3, 1e-9);
  EXPECT_NEAR(turn_at(0.1001).pitch_rad, 0.3, 1e-4) << "the swing begins with the turned sole";
  EXPECT_LT(EdgeTurnOf(foot, plan.footsteps.footholds[1].X_WF, course.At(0.3).X_WF).pitch_rad, 1e-12);
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

TEST(FootCourse, RefusesAPlanWithoutASwing) {
  const RobotModel model = AnyRobot("a1");
  MotionPlan plan = SteppingPlan(model);
  plan.swings.clear();
  EXPECT_THROW(FootCourse(model, plan, 0), InvalidArgument);
}

TEST(FootRolls, AreThoseOfASphereThatTurns) {
  const RobotModel model = AnyRobot("a1");
  MotionPlan plan = SteppingPlan(model);
  // The whole robot pitches evenly: each ball rolls forward by its radius times the angle.
  constexpr double kTurn = 0.004;
  for (std::size_t k = 0; k < plan.whole_body.q.size(); ++k) {
    const Matrix3 R = RotationExp(kTurn * static_cast<double>(k) * Vector3::UnitY());
    plan.whole_body.q[k].segment<4>(3) = Quaternion(R * BaseRotation(StandingConfiguration(model))).coeffs();
  }
  const FootRolls rolls = RollsOf(model, plan.whole_body, CoursesOf(model, plan));
  const double radius = model.feet[1].radius;
  ASSERT_GT(radius, 0.0);
  EXPECT_LT((rolls.roll_W[1].back() - Vector3(80.0 * kTurn * radius, 0.0, 0.0)).norm(), 1e-9);
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
