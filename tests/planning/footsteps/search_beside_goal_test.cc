// SPDX-License-Identifier: BSD-3-Clause
#include "planning/footsteps/search_beside_goal.h"

#include <gtest/gtest.h>

#include <cmath>

#include "kinematics/model/load_robot.h"
#include "planning/footsteps/uneven_footsteps.h"
#include "planning/gait/find_gait.h"
#include "planning/paths/standing_feet.h"

namespace gaitwright {
namespace {

FootstepQuery ForwardTrot(const RobotModel& model, double length_m, double speed_m_s) {
  const Gait trot = FindGait(model, "trot", speed_m_s, {}).value();
  return {trot, RouteAlong({length_m, 0.0, 0.0}, 0.2), speed_m_s * trot.cycle_s};
}

/// Level ground with spikes on discs around the places of the feet at the goal.
Terrain SpikesAtTheGoal(const RobotModel& model, double goal_x_m, double radius_m) {
  HeightField field;
  field.name = "spikes";
  field.resolution_m = 0.01;
  field.origin_W = {-1.0, -0.6};
  field.columns = 301;
  field.rows = 121;
  for (int row = 0; row < field.rows; ++row) {
    for (int column = 0; column < field.columns; ++column) {
      const Vector2 p = field.origin_W + field.resolution_m * Vector2(column, row);
      bool spiky = false;
      for (const Pose& X_BF : StandingFeet(model))
        spiky = spiky || (X_BF.translation().head<2>() + Vector2(goal_x_m, 0.0) - p).norm() < radius_m;
      field.height_m.push_back(spiky && (row + column) % 2 == 0 ? 0.02 : 0.0);
    }
  }
  return {"spikes", {}, {field}, {}};
}

TEST(SearchBesideGoal, EndsWhereTheFeetCanStand) {
  const RobotModel a1 = LoadNamedRobot("a1").value();
  const FootstepQuery query = ForwardTrot(a1, 0.6, 0.3);
  const FootstepSearchOptions options;
  const double tolerance_m = options.goal_tolerance * a1.leg_length_m();
  const Terrain spikes = SpikesAtTheGoal(a1, 0.6, tolerance_m + 0.02);
  EXPECT_FALSE(SearchFootsteps(a1, spikes, query, {}, options).ok());
  const Result<FootstepSequence> beside = SearchBesideGoal(a1, spikes, query, {}, options);
  ASSERT_TRUE(beside.ok()) << beside.failure().message;
  const FootstepSkeleton skeleton = SearchSkeleton(a1, spikes, query, {}).value();
  ASSERT_EQ(skeleton.warnings.size(), 1U);
  const double moved_m = std::hypot(skeleton.goal.x_m - 0.6, skeleton.goal.y_m);
  EXPECT_GT(moved_m, 1e-3);
  EXPECT_LE(moved_m, 4.0 * tolerance_m);
  const PlanarPose end = skeleton.path.pose.back();
  EXPECT_EQ(end.x_m, skeleton.goal.x_m);
}

}  // namespace
}  // namespace gaitwright
