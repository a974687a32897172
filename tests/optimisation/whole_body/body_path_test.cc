// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/whole_body/body_path.h"

#include <gtest/gtest.h>

#include <cmath>

#include "kinematics/model/load_robot.h"
#include "kinematics/spatial/rotation.h"
#include "planning/gait/find_gait.h"

namespace gaitwright {
namespace {

/// A trot that turns; from the start its feet stand on a plane that slopes forward and to the left.
FootstepSkeleton OnPlane(const RobotModel& model, const Vector2& slope_W) {
  WalkCommand command;
  command.speed_m_s = 0.3;
  command.yaw_rate_rad_s = 0.3;
  command.distance_m = 0.5;
  FootstepSkeleton skeleton = *PlanFootsteps(model, FlatTerrain(), *FindGait(model, "trot", 0.3, {}), command, {});
  for (Foothold& foothold : skeleton.footsteps.footholds)
    foothold.X_WF.translation().z() = slope_W.dot(foothold.X_WF.translation().head<2>());
  return skeleton;
}

TEST(BodyPath, IsLevelAndOnTheGroundWhereTheFeetAre) {
  const RobotModel model = *LoadNamedRobot("a1");
  const BodyPath body(model, OnPlane(model, Vector2::Zero()), 0.5);
  for (double t = 0.0; t < 3.0; t += 0.1) {
    EXPECT_EQ(body.GroundAt(t).value, 0.0);
    EXPECT_NEAR(body.TurningAt(t).R_WB(2, 2), 1.0, 1e-15);
    EXPECT_NEAR(YawOf(body.TurningAt(t).R_WB), body.YawAt(t), 1e-12);
  }
}

TEST(BodyPath, FollowsThePlaneThatTheFeetStandOn) {
  const RobotModel model = *LoadNamedRobot("a1");
  const Vector2 slope(0.2, -0.1);
  const FootstepSkeleton skeleton = OnPlane(model, slope);
  const BodyPath body(model, skeleton, 0.5);
  const Vector3 normal = Vector3(-slope.x(), -slope.y(), 1.0).normalized();
  const double end = skeleton.schedule.end_s();
  EXPECT_NEAR((body.TurningAt(0.0).R_WB.col(2) - normal).norm(), 0.0, 1e-9);
  EXPECT_NEAR((body.TurningAt(end).R_WB.col(2) - normal).norm(), 0.0, 1e-9);
  const PlanarPose& goal = skeleton.path.pose.back();
  EXPECT_NEAR(body.GroundAt(end).value, slope.dot(Vector2(goal.x_m, goal.y_m)), 1e-9);
  double furthest = 0.0;
  for (double t = 0.0; t < end; t += 0.05)
    furthest = std::max(furthest, (body.TurningAt(t).R_WB.col(2) - normal).norm());
  EXPECT_LT(furthest, 0.05);
}

TEST(BodyPath, HasTheRatesOfItsTurning) {
  const RobotModel model = *LoadNamedRobot("a1");
  FootstepSkeleton skeleton = OnPlane(model, {0.2, -0.1});
  for (Foothold& foothold : skeleton.footsteps.footholds) {
    const Vector2 p = foothold.X_WF.translation().head<2>();
    foothold.X_WF.translation().z() = 0.05 * std::sin(20.0 * p.x()) + 0.03 * std::sin(25.0 * p.y());
  }
  const BodyPath body(model, skeleton, 0.1);
  constexpr double h = 1e-5;
  double fastest = 0.0;
  for (double t = 1.02; t < 2.5; t += 0.07) {  // between knots, where the splines' third derivatives are smooth
    const BaseTurning at = body.TurningAt(t), before = body.TurningAt(t - h), after = body.TurningAt(t + h);
    const Vector3 rate = RotationLog(after.R_WB * before.R_WB.transpose()) / (2.0 * h);
    const Vector3 acceleration = (after.w_WB - before.w_WB) / (2.0 * h);
    EXPECT_NEAR((rate - at.w_WB).norm(), 0.0, 1e-6) << t;
    EXPECT_NEAR((acceleration - at.alpha_WB).norm(), 0.0, 1e-3) << t;
    fastest = std::max(fastest, Vector2(at.w_WB.x(), at.w_WB.y()).norm());
  }
  EXPECT_GT(fastest, 0.05) << "a body that does not tilt shows nothing";
}

}  // namespace
}  // namespace gaitwright
