// SPDX-License-Identifier: BSD-3-Clause
#include "planning/footsteps/course.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "kinematics/model/load_robot.h"
#include "planning/footsteps/plan_footsteps.h"
#include "planning/gait/find_gait.h"

namespace gaitwright {
namespace {

using Extent = WalkCommand::Extent;

FootstepSkeleton Planned(const WalkCommand& command, const std::string& robot = "a1") {
  const RobotModel model = *LoadNamedRobot(robot);
  const Result<Gait> gait = FindGait(model, "", CommandedSpeed(model, command), {});
  const Result<FootstepSkeleton> skeleton = PlanFootsteps(model, FlatTerrain(), *gait, command, {});
  EXPECT_TRUE(skeleton.ok()) << skeleton.failure().message;
  return *skeleton;
}

double LengthOf(const BasePath& path) {
  double length = 0.0;
  for (std::size_t k = 1; k < path.pose.size(); ++k)
    length += std::hypot(path.pose[k].x_m - path.pose[k - 1].x_m, path.pose[k].y_m - path.pose[k - 1].y_m);
  return length;
}

TEST(Course, YawRateBendsAPathOfTheRequestedLength) {
  const double own = LoadNamedRobot("a1")->nominal_speed_m_s;
  for (const double rate : {0.5, -0.2}) {
    WalkCommand command;
    command.yaw_rate_rad_s = rate;
    command.distance_m = 1.5;
    const FootstepSkeleton skeleton = Planned(command);
    EXPECT_NEAR(LengthOf(skeleton.path), 1.5, 1e-4);
    EXPECT_NEAR(skeleton.goal.yaw_rad, rate * 1.5 / own, 1e-9);
    const double radius = own / rate;  // radius of the circle given by both speeds
    EXPECT_NEAR(skeleton.goal.x_m, radius * std::sin(skeleton.goal.yaw_rad), 1e-9);
    EXPECT_NEAR(skeleton.goal.y_m, radius * (1.0 - std::cos(skeleton.goal.yaw_rad)), 1e-9);
  }
}

TEST(Course, YawRateAloneIsAQuarterTurn) {
  for (const double rate : {0.4, -0.4}) {
    WalkCommand command;
    command.yaw_rate_rad_s = rate;
    const PlanarPose goal = Planned(command).goal;
    EXPECT_NEAR(goal.yaw_rad, std::copysign(0.5 * std::numbers::pi, rate), 1e-12);
    EXPECT_NEAR(std::hypot(goal.x_m, goal.y_m), 0.0, 1e-12);
  }
}

TEST(Course, ANegativeSpeedIsTheSamePathBackward) {
  for (const char* robot : {"a1", "nao"}) {
    WalkCommand command;
    command.speed_m_s = 0.1;
    command.distance_m = 0.6;
    const FootstepSkeleton forward = Planned(command, robot);
    command.speed_m_s = -0.1;
    const FootstepSkeleton back = Planned(command, robot);
    EXPECT_NEAR(back.goal.x_m, -0.6, 1e-9);
    EXPECT_NEAR(back.goal.x_m, -forward.goal.x_m, 1e-9);
    EXPECT_NEAR(LengthOf(back.path), 0.6, 1e-4);
    command.extent = Extent::kGoal;
    command.goal_x_m = 1.0;
    EXPECT_NE(CheckCommand(command), std::nullopt) << "the goal gives the direction";
  }
}

TEST(Course, HalfATurnMayBeRoundedUp) {
  WalkCommand command;
  command.extent = Extent::kGoal;
  command.goal_yaw_rad = 3.1416;
  EXPECT_EQ(CheckCommand(command), std::nullopt);
  EXPECT_NEAR(Planned(command).goal.yaw_rad, 3.1416, 1e-9);
  command.goal_yaw_rad = -3.3;
  EXPECT_NE(CheckCommand(command), std::nullopt);
}

/// Sideways, two feet do not pass each other: the legs spread by a whole stride instead of half of one.
TEST(Course, StepsOfABipedAreFittedToTwiceTheLateralSpeed) {
  const RobotModel nao = *LoadNamedRobot("nao"), a1 = *LoadNamedRobot("a1");
  WalkCommand command;
  EXPECT_EQ(SpeedOfSteps(nao, command), nao.nominal_speed_m_s);
  command.lateral_speed_m_s = -0.3;
  EXPECT_EQ(SpeedOfSteps(nao, command), 0.6);
  EXPECT_EQ(SpeedOfSteps(a1, command), std::max(0.3, a1.nominal_speed_m_s));
  command.speed_m_s = -0.8;
  EXPECT_EQ(SpeedOfSteps(nao, command), 0.8);
}

TEST(Course, DurationIsWholeCyclesAtTheCommandedSpeeds) {
  WalkCommand command;
  command.extent = Extent::kDuration;
  command.speed_m_s = 0.25;
  command.yaw_rate_rad_s = 0.3;
  const RobotModel a1 = *LoadNamedRobot("a1");
  const double cycle = FindGait(a1, "", 0.25, {})->cycle_s;
  for (const double duration : {0.01, 3.0, 6.1}) {
    command.duration_s = duration;
    const FootstepSkeleton skeleton = Planned(command);
    const auto& phases = skeleton.schedule.phases;
    const double stepping = phases.back().start_s - phases.front().end_s;
    EXPECT_NEAR(stepping, std::max(cycle, duration), cycle);
    const double cruise = skeleton.goal.yaw_rad / 0.3;
    EXPECT_NEAR(LengthOf(skeleton.path), 0.25 * cruise, 1e-4) << "one time at both speeds";
    EXPECT_LT(cruise, stepping);
    EXPECT_GT(cruise, stepping - 1.5 * cycle);
    const PlanarPose a = PoseAt(skeleton.path, 0.5 * skeleton.schedule.end_s());
    const PlanarPose b = PoseAt(skeleton.path, 0.5 * skeleton.schedule.end_s() + 0.1);
    if (duration > 2.0) {
      EXPECT_NEAR(std::hypot(b.x_m - a.x_m, b.y_m - a.y_m), 0.025, 1e-4);
    }
  }
}

/// The largest change of speed over a quarter of a second, per second.
double GreatestAcceleration(const BasePath& path, double end_s) {
  constexpr double kTime = 0.25, kStep = 0.01;
  const auto speed = [&](double t) {
    const PlanarPose a = PoseAt(path, t), b = PoseAt(path, t + kStep);
    return std::hypot(b.x_m - a.x_m, b.y_m - a.y_m) / kStep;
  };
  double greatest = 0.0;
  for (double t = 0.0; t < end_s; t += kStep)
    greatest = std::max(greatest, std::abs(speed(t + kTime) - speed(t)) / kTime);
  return greatest;
}

TEST(Course, FastWalksGainTheirSpeedOverLonger) {
  const RobotModel a1 = *LoadNamedRobot("a1");
  WalkCommand command;
  command.speed_m_s = 1.5;
  command.distance_m = 5.0;
  const Gait trot = *FindGait(a1, "trot", 1.5, {});
  FootstepOptions options;
  const auto greatest = [&] {
    const Result<FootstepSkeleton> skeleton = PlanFootsteps(a1, FlatTerrain(), trot, command, options);
    return GreatestAcceleration(skeleton->path, skeleton->schedule.end_s());
  };
  for (const double most : {0.5, 1.0, 2.0}) {
    options.ramp.acceleration_m_s2 = most;
    EXPECT_LT(greatest(), 2.0 * most) << "a smooth ramp is steeper in its middle";
    EXPECT_GT(greatest(), 0.9 * most);
  }
  options.ramp.acceleration_m_s2 = 0.0;
  EXPECT_GT(greatest(), 4.0) << "within a cycle";
}

TEST(Course, DurationOfATurnAloneStaysOnTheSpot) {
  WalkCommand command;
  command.extent = Extent::kDuration;
  command.duration_s = 5.0;
  command.yaw_rate_rad_s = -0.3;
  const PlanarPose goal = Planned(command).goal;
  EXPECT_NEAR(std::hypot(goal.x_m, goal.y_m), 0.0, 1e-12);
  EXPECT_LT(goal.yaw_rad, -1.2);
}

TEST(Course, DurationMustBeMoreThanNothingAndNotTooLong) {
  const RobotModel a1 = *LoadNamedRobot("a1");
  WalkCommand command;
  command.extent = Extent::kDuration;
  for (const double duration : {0.0, -1.0, 700.0}) {
    command.duration_s = duration;
    const auto refused = PlanFootsteps(a1, FlatTerrain(), *FindGait(a1, "", 0.3, {}), command, {});
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.failure().kind, FailureKind::kBadInput);
  }
}

}  // namespace
}  // namespace gaitwright
