// SPDX-License-Identifier: BSD-3-Clause
#include "planning/footsteps/plan_footsteps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kinematics/spatial/rotation.h"
#include "planning/gait/find_gait.h"
#include "planning/paths/base_path.h"
#include "planning/paths/standing_feet.h"
#include "tests/named_robot.h"

namespace gaitwright {
namespace {

WalkCommand ForwardFor(double distance_m, double speed_m_s, double yaw_rate_rad_s = 0.0) {
  WalkCommand command;
  command.distance_m = distance_m;
  command.speed_m_s = speed_m_s;
  command.yaw_rate_rad_s = yaw_rate_rad_s;
  return command;
}

FootstepSkeleton SkeletonOf(const char* robot, const WalkCommand& command, const Terrain& terrain = FlatTerrain(),
                            const FootstepOptions& options = {}) {
  const RobotModel& model = NamedRobot(robot);
  const Gait gait = FindGait(model, "", CommandedSpeed(model, command), {}).value();
  const Result<FootstepSkeleton> skeleton = PlanFootsteps(model, terrain, gait, command, options);
  EXPECT_TRUE(skeleton.ok()) << skeleton.failure().message;
  return skeleton.ok() ? *skeleton : FootstepSkeleton{};
}

class PlanFootstepsTest : public testing::TestWithParam<const char*> {};

TEST_P(PlanFootstepsTest, EachIntervalOfContactHasOneFoothold) {
  const RobotModel& model = NamedRobot(GetParam());
  const FootstepSkeleton skeleton = SkeletonOf(GetParam(), ForwardFor(0.5, 0.1));
  std::size_t intervals = 0;
  for (int foot = 0; foot < static_cast<int>(model.feet.size()); ++foot) {
    for (const ContactInterval& interval : IntervalsOf(skeleton.schedule, foot)) {
      ++intervals;
      const auto own = std::count_if(skeleton.footsteps.footholds.begin(), skeleton.footsteps.footholds.end(),
                                     [&](const Foothold& foothold) {
                                       return foothold.foot == foot && foothold.touchdown_s == interval.start_s &&
                                              foothold.liftoff_s == interval.end_s;
                                     });
      EXPECT_EQ(own, 1) << "foot " << foot << " from " << interval.start_s << " s";
    }
  }
  EXPECT_EQ(skeleton.footsteps.footholds.size(), intervals);
}

TEST_P(PlanFootstepsTest, StandsForAsLongAsAskedAtBothEnds) {
  FootstepOptions options;
  options.initial_stand_s = 0.45;
  options.final_stand_s = 0.7;
  const FootstepSkeleton skeleton = SkeletonOf(GetParam(), ForwardFor(0.4, 0.1), FlatTerrain(), options);
  const ContactPhase &first = skeleton.schedule.phases.front(), &last = skeleton.schedule.phases.back();
  EXPECT_NEAR(first.end_s, 0.45, 1e-9);
  EXPECT_NEAR(last.end_s - last.start_s, 0.7, 1e-9);
  EXPECT_NEAR(skeleton.path.time_s.back(), skeleton.schedule.end_s(), 1e-9);
}

TEST_P(PlanFootstepsTest, ATurnToTheRightMirrorsOneToTheLeft) {
  const FootstepSkeleton left = SkeletonOf(GetParam(), ForwardFor(0.5, 0.1, 0.2));
  const FootstepSkeleton right = SkeletonOf(GetParam(), ForwardFor(0.5, 0.1, -0.2));
  EXPECT_GT(left.goal.yaw_rad, 0.3);
  EXPECT_NEAR(left.goal.x_m, right.goal.x_m, 1e-12);
  EXPECT_NEAR(left.goal.y_m, -right.goal.y_m, 1e-12);
  EXPECT_NEAR(left.goal.yaw_rad, -right.goal.yaw_rad, 1e-12);
}

TEST_P(PlanFootstepsTest, OnALevelPlaneAtAnotherHeightFootholdsAreThere) {
  Terrain raised = FlatTerrain();
  raised.patches[0].X_WT.translation().z() = 0.3;
  FootstepPlan footsteps = SkeletonOf(GetParam(), ForwardFor(0.4, 0.1)).footsteps;
  PutOnGround(raised, footsteps);
  for (const Foothold& foothold : footsteps.footholds) {
    EXPECT_NEAR(foothold.X_WF.translation().z(), 0.3, 1e-12);
    EXPECT_EQ(foothold.patch, 0);
  }
}

TEST_P(PlanFootstepsTest, OnASlopeTheFootFrameStandsOnItAndKeepsItsHeading) {
  Terrain slope = FlatTerrain();
  slope.patches[0].X_WT.linear() = Eigen::AngleAxisd(-0.2, Vector3::UnitY()).toRotationMatrix();
  FootstepPlan footsteps = SkeletonOf(GetParam(), ForwardFor(0.4, 0.1)).footsteps;
  PutOnGround(slope, footsteps);
  for (const Foothold& foothold : footsteps.footholds) {
    const Vector3 p = foothold.X_WF.translation();
    EXPECT_NEAR(p.z(), std::tan(0.2) * p.x(), 1e-9);
    EXPECT_LT((foothold.X_WF.linear().col(2) - slope.patches[0].X_WT.linear().col(2)).norm(), 1e-9);
    EXPECT_NEAR(YawOf(foothold.X_WF.linear()), 0.0, 1e-6);
  }
}

TEST_P(PlanFootstepsTest, TheFarthestFootholdIsNamedOnceALegReachesLess) {
  const RobotModel& model = NamedRobot(GetParam());
  const FootstepSkeleton skeleton = SkeletonOf(GetParam(), ForwardFor(0.4, 0.1));
  EXPECT_FALSE(ReasonOutOfReach(model, skeleton, 1.0));
  const auto failure = ReasonOutOfReach(model, skeleton, 0.3);
  ASSERT_TRUE(failure);
  EXPECT_EQ(failure->kind, FailureKind::kInfeasible);
  EXPECT_EQ(failure->code, FailureCode::kFootholdOutOfReach);
}

TEST_P(PlanFootstepsTest, AGaitForOtherFeetIsABadCommand) {
  const RobotModel& model = NamedRobot(GetParam());
  const auto failure = ReasonNotWalked(model, StandingGait(3), ForwardFor(0.4, 0.1));
  ASSERT_TRUE(failure);
  EXPECT_EQ(failure->kind, FailureKind::kBadInput);
  EXPECT_EQ(failure->code, FailureCode::kCommand);
  EXPECT_FALSE(ReasonNotWalked(model, StandingGait(static_cast<int>(model.feet.size())), ForwardFor(0.4, 0.1)));
  WalkCommand backwards = ForwardFor(-0.4, 0.1);
  EXPECT_TRUE(ReasonNotWalked(model, StandingGait(static_cast<int>(model.feet.size())), backwards));
}

INSTANTIATE_TEST_SUITE_P(Robots, PlanFootstepsTest, testing::Values("a1", "nao"));

}  // namespace
}  // namespace gaitwright
