// SPDX-License-Identifier: BSD-3-Clause
// Counted footfalls: invariants for any number of feet and steps, and any direction.
#include <gtest/gtest.h>

#include <map>

#include "planning/footsteps/plan_footsteps.h"
#include "planning/footsteps/uneven_footsteps.h"
#include "planning/gait/find_gait.h"
#include "planning/paths/standing_feet.h"
#include "tests/planning/footsteps/synthetic_walker.h"

namespace gaitwright {
namespace {

const RobotModel& Robot(const std::string& name) {
  static std::map<std::string, RobotModel> robots;
  if (!robots.contains(name)) robots.emplace(name, name == "walker6" ? Walker(3) : *LoadNamedRobot(name));
  return robots.at(name);
}

WalkCommand Steps(int count) {
  WalkCommand command;
  command.extent = WalkCommand::Extent::kSteps;
  command.steps = count;
  return command;
}

FootstepSkeleton Planned(const RobotModel& model, const std::string& gait, const WalkCommand& command) {
  const Result<Gait> found = FindGait(model, gait, CommandedSpeed(model, command), {});
  const Result<FootstepSkeleton> skeleton = PlanFootsteps(model, FlatTerrain(), *found, command, {});
  EXPECT_TRUE(skeleton.ok()) << skeleton.failure().message;
  return *skeleton;
}

std::vector<Foothold> OfFoot(const FootstepSkeleton& skeleton, int foot) {
  std::vector<Foothold> own;
  for (const Foothold& foothold : skeleton.footsteps.footholds) {
    if (foothold.foot == foot) own.push_back(foothold);
  }
  return own;
}

class CountedSteps : public testing::TestWithParam<std::tuple<std::string, std::string>> {
 protected:
  const RobotModel& model() const { return Robot(std::get<0>(GetParam())); }
  const std::string& gait() const { return std::get<1>(GetParam()); }
  int num_feet() const { return static_cast<int>(model().feet.size()); }

  void ExpectLaws(const WalkCommand& command) const {
    SCOPED_TRACE(testing::Message() << command.steps << " steps");
    const FootstepSkeleton skeleton = Planned(model(), gait(), command);
    const std::vector<Pose> standing = StandingFeet(model());
    EXPECT_EQ(static_cast<int>(skeleton.footsteps.footholds.size()), command.steps + num_feet());
    for (int foot = 0; foot < num_feet(); ++foot) {
      const auto own = OfFoot(skeleton, foot);
      const Pose& X_BF = standing[static_cast<std::size_t>(foot)];
      EXPECT_LT((own.front().X_WF.matrix() - X_BF.matrix()).norm(), 1e-9) << "foot " << foot << " starts as it stands";
      const Pose X_WF_goal = Carried(skeleton.goal, X_BF);
      EXPECT_LT((own.back().X_WF.matrix() - X_WF_goal.matrix()).norm(), 1e-9) << "foot " << foot << " closes";
    }
  }
};

INSTANTIATE_TEST_SUITE_P(Robots, CountedSteps,
                         testing::Values(std::tuple{"nao", ""}, std::tuple{"a1", "trot"}, std::tuple{"a1", "walk"},
                                         std::tuple{"walker6", ""}, std::tuple{"walker6", "wave"}),
                         [](const auto& tested) {
                           const std::string gait = std::get<1>(tested.param);
                           return std::get<0>(tested.param) + (gait.empty() ? "" : "_" + gait);
                         });

TEST_P(CountedSteps, StartStandingAndCloseTheStanceAtTheGoal) {
  for (int count = 1; count <= 12; ++count) {
    WalkCommand command = Steps(count);
    command.step_length_m = 0.08 * model().leg_length_m();
    ExpectLaws(command);
    command.lateral_speed_m_s = 0.02;
    command.yaw_rate_rad_s = -0.1;
    ExpectLaws(command);
  }
}

TEST_P(CountedSteps, OneMoreRoundOfFeetGoesOneRoundOfStepsFarther) {
  const double length = 0.05 * model().leg_length_m();
  for (int count = num_feet(); count <= 3 * num_feet(); ++count) {
    WalkCommand command = Steps(count), longer = Steps(count + num_feet());
    command.step_length_m = longer.step_length_m = length;
    EXPECT_NEAR(Planned(model(), gait(), longer).goal.x_m,
                Planned(model(), gait(), command).goal.x_m + num_feet() * length, 1e-12);
  }
}

TEST_P(CountedSteps, OfFewerThanTheFeetEndWhereTheyStartAndSaySo) {
  for (int count = 1; count < num_feet(); ++count) {
    WalkCommand command = Steps(count);
    command.step_length_m = 0.03;
    const FootstepSkeleton skeleton = Planned(model(), gait(), command);
    EXPECT_EQ(skeleton.goal, PlanarPose{});
    ASSERT_EQ(skeleton.warnings.size(), 1U);
    command.step_length_m = 0.0;
    EXPECT_TRUE(Planned(model(), gait(), command).warnings.empty());
  }
}

TEST_P(CountedSteps, SpeedIsStepLengthOverTheTimeOfAFootfall) {
  const Result<Gait> found = FindGait(model(), gait(), model().nominal_speed_m_s, {});
  const double footfall_s = found->cycle_s / num_feet();
  WalkCommand by_speed = Steps(3 * num_feet()), by_length = by_speed;
  by_speed.speed_m_s = model().nominal_speed_m_s;
  by_length.step_length_m = model().nominal_speed_m_s * footfall_s;
  EXPECT_NEAR(Planned(model(), gait(), by_speed).goal.x_m, Planned(model(), gait(), by_length).goal.x_m, 1e-12);
}

TEST_P(CountedSteps, MirrorEachOther) {
  WalkCommand left = Steps(2 * num_feet()), right = left;
  left.lateral_speed_m_s = 0.02;
  right.lateral_speed_m_s = -0.02;
  const PlanarPose a = Planned(model(), gait(), left).goal, b = Planned(model(), gait(), right).goal;
  EXPECT_GT(a.y_m, 0.0);
  EXPECT_NEAR(a.y_m, -b.y_m, 1e-12);
}

TEST(CountedStepsOfABiped, KeepTheFeetApart) {
  const RobotModel& nao = Robot("nao");
  const std::vector<Pose> standing = StandingFeet(nao);
  const double apart = standing[0].translation().y() - standing[1].translation().y();
  for (const double speed : {0.02, -0.02}) {
    WalkCommand command = Steps(8);
    command.lateral_speed_m_s = speed;
    const FootstepSkeleton skeleton = Planned(nao, "", command);
    for (const ContactPhase& phase : skeleton.schedule.phases) {
      const auto y = [&](int foot) {
        const int at = FootholdAt(skeleton.footsteps, foot, phase.start_s);
        return skeleton.footsteps.footholds[static_cast<std::size_t>(at)].X_WF.translation().y();
      };
      EXPECT_GE(y(0) - y(1), apart - 1e-9);
    }
  }
}

TEST(CountedStepsOfAQuadruped, AreStridesOfOneRoundBetweenTheRamps) {
  WalkCommand command = Steps(24);
  command.step_length_m = 0.02;
  const FootstepSkeleton skeleton = Planned(Robot("a1"), "walk", command);
  for (int foot = 0; foot < 4; ++foot) {
    const auto own = OfFoot(skeleton, foot);
    for (std::size_t i = 2; i + 1 < own.size(); ++i) {
      const double stride = own[i].X_WF.translation().x() - own[i - 1].X_WF.translation().x();
      EXPECT_NEAR(stride, 0.08, 1e-12);
    }
  }
}

TEST(CountedStepsCommand, LengthAndSpeedContradict) {
  WalkCommand command = Steps(4);
  command.speed_m_s = 0.1;
  command.step_length_m = 0.05;
  const RobotModel& a1 = Robot("a1");
  const auto refused = PlanFootsteps(a1, FlatTerrain(), *FindGait(a1, "", 0.1, {}), command, {});
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.failure().kind, FailureKind::kBadInput);
}

WalkCommand Distance(double distance_m) {
  WalkCommand command;
  command.extent = WalkCommand::Extent::kDistance;
  command.distance_m = distance_m;
  return command;
}

TEST(CountedInStrides, AsFewLeapsAsReachAllOfOneLength) {
  const RobotModel& a1 = Robot("a1");
  const Gait jump = *FindGait(a1, "jump", 0.3, {});
  for (const auto& [distance, leaps] : {std::pair{0.4, 1}, {0.45, 1}, {0.46, 2}, {0.9, 2}, {1.0, 3}, {0.05, 1}}) {
    ASSERT_EQ(LeastStrides(0.45, Distance(distance)), leaps) << distance;
    const WalkCommand counted = CountedInStrides(jump, leaps, Distance(distance));
    EXPECT_EQ(counted.extent, WalkCommand::Extent::kSteps);
    EXPECT_EQ(counted.steps, 4 * leaps) << distance;
    const FootstepSkeleton skeleton = Planned(a1, "jump", counted);
    EXPECT_NEAR(skeleton.goal.x_m, distance, 1e-9);
    const std::vector<Foothold> own = OfFoot(skeleton, 2);
    ASSERT_EQ(own.size(), static_cast<std::size_t>(leaps) + 1);
    for (std::size_t k = 1; k < own.size(); ++k)
      EXPECT_NEAR(own[k].X_WF.translation().x() - own[k - 1].X_WF.translation().x(), distance / leaps, 1e-9);
  }
}

TEST(CountedInStrides, GoalsAreReachedInEqualStrides) {
  const RobotModel& a1 = Robot("a1");
  const Gait jump = *FindGait(a1, "jump", 0.3, {});
  WalkCommand goal;
  goal.extent = WalkCommand::Extent::kGoal;
  goal.goal_x_m = 0.2;
  goal.goal_y_m = -0.1;
  goal.goal_yaw_rad = 1.5;
  ASSERT_EQ(LeastStrides(0.45, goal), 1);
  for (const int leaps : {1, 2}) {
    const WalkCommand counted = CountedInStrides(jump, leaps, goal);
    EXPECT_TRUE(IsCounted(counted));
    EXPECT_EQ(counted.extent, WalkCommand::Extent::kGoal);
    const FootstepSkeleton skeleton = Planned(a1, "jump", counted);
    EXPECT_NEAR(skeleton.goal.x_m, 0.2, 1e-9);
    EXPECT_NEAR(skeleton.goal.y_m, -0.1, 1e-9);
    EXPECT_NEAR(skeleton.goal.yaw_rad, 1.5, 1e-9);
    EXPECT_EQ(OfFoot(skeleton, 0).size(), static_cast<std::size_t>(leaps) + 1);
  }
}

TEST(LeastStrides, CommandsWithSpeedsAreNotCounted) {
  WalkCommand fast = Distance(1.0), turning = Distance(1.0);
  fast.speed_m_s = 0.5;
  turning.yaw_rate_rad_s = 0.2;
  for (const WalkCommand& command : {fast, turning, Steps(4), Distance(0.0)}) EXPECT_EQ(LeastStrides(0.45, command), 0);
  EXPECT_EQ(LeastStrides(0.0, Distance(1.0)), 0);
}

}  // namespace
}  // namespace gaitwright
