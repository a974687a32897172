// SPDX-License-Identifier: BSD-3-Clause
// A wall on the path of a walk that is feasible without it.
#include <gtest/gtest.h>

#include "kinematics/model/load_robot.h"
#include "optimisation/search/plan_within.h"
#include "tests/planning/paths/walled_grounds.h"

namespace gaitwright {
namespace {

/// A goal straight forward, with room beside the path.
struct Goal {
  const char* robot;
  double goal_x_m;
};

void PrintTo(const Goal& goal, std::ostream* out) { *out << goal.robot; }

class AddedWall : public testing::TestWithParam<Goal> {
 protected:
  Result<PlannedWalk> Plan(const std::vector<Obstacle>& obstacles) const {
    WalkRequest request;
    request.command.extent = WalkCommand::Extent::kGoal;
    request.command.goal_x_m = GetParam().goal_x_m;
    return PlanWithin(model_, Walled(obstacles), request);
  }
  double Middle() const { return 0.5 * GetParam().goal_x_m; }

  const RobotModel model_ = *LoadNamedRobot(GetParam().robot);
};

/// Largest lateral distance of the base [m].
double LargestLateralOffset(const MotionPlan& plan) {
  double farthest = 0.0;
  for (const VectorX& q : plan.whole_body.q) farthest = std::max(farthest, std::abs(q[1]));
  return farthest;
}

TEST_P(AddedWall, IsWalkedAround) {
  const auto without = Plan({});
  ASSERT_TRUE(without.ok()) << without.failure().message;
  EXPECT_TRUE(without->audit.pass());
  EXPECT_LT(LargestLateralOffset(without->motion.plan), 0.1);

  const double half = 0.3 * GetParam().goal_x_m / 2.0;
  const auto with = Plan({Wall("wall", {Middle(), -half}, {Middle(), half})});
  ASSERT_TRUE(with.ok()) << with.failure().message;
  EXPECT_TRUE(with->audit.pass()) << AuditText(with->audit);
  EXPECT_GT(LargestLateralOffset(with->motion.plan), half);  // the base passes beyond the end of the wall
  const VectorX& last = with->motion.plan.whole_body.q.back();
  EXPECT_NEAR(last[0], GetParam().goal_x_m, 0.1);
  EXPECT_NEAR(last[1], 0.0, 0.1);
}

TEST_P(AddedWall, IsRefusedWhereItBlocksTheRoute) {
  // Between two walls along the path, with enough room to walk.
  const double half_width = 2.0 * model_.leg_length_m(), end = GetParam().goal_x_m + 1.0;
  std::vector<Obstacle> walls = {
      Wall("left", {-1.0, half_width}, {end, half_width}), Wall("right", {-1.0, -half_width}, {end, -half_width}),
      Wall("behind", {-1.0, -half_width}, {-1.0, half_width}), Wall("ahead", {end, -half_width}, {end, half_width})};
  const auto open = Plan(walls);
  ASSERT_TRUE(open.ok()) << open.failure().message;
  EXPECT_TRUE(open->audit.pass()) << AuditText(open->audit);

  walls.push_back(Wall("wall", {Middle(), -half_width}, {Middle(), half_width}));
  const auto closed = Plan(walls);
  ASSERT_FALSE(closed.ok());
  EXPECT_EQ(closed.failure().kind, FailureKind::kInfeasible);
  EXPECT_EQ(closed.failure().code, FailureCode::kWayBlocked);
  EXPECT_NE(closed.failure().message.find("wall"), std::string::npos) << closed.failure().message;
}

INSTANTIATE_TEST_SUITE_P(Robots, AddedWall, testing::Values(Goal{"a1", 3.0}, Goal{"nao", 1.2}),
                         [](const auto& tested) { return std::string(tested.param.robot); });

}  // namespace
}  // namespace gaitwright
