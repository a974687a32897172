// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "kinematics/base/result.h"
#include "kinematics/spatial/rotation.h"
#include "optimisation/whole_body/foot_course_internal.h"
#include "planning/plan/heel_off_internal.h"
#include "tests/kinematics/made_robots.h"
#include "tests/optimisation/whole_body/stepping_plan.h"

namespace gaitwright {
namespace {

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

}  // namespace
}  // namespace gaitwright
