// SPDX-License-Identifier: BSD-3-Clause
#include "planning/footsteps/plan_sequence.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kinematics/model/load_robot.h"
#include "planning/gait/find_gait.h"
#include "planning/paths/base_path.h"
#include "planning/paths/standing_feet.h"
#include "planning/plan/built_in_terrain.h"
#include "tests/named_robot.h"

namespace gaitwright {
namespace {

constexpr double kSame = 1e-9;

WalkPart Part(const std::string& gait, double speed_m_s, double distance_m) {
  WalkPart part;
  part.command.speed_m_s = speed_m_s;
  part.command.distance_m = distance_m;
  part.gait = FindGait(NamedRobot("a1"), gait, speed_m_s, {}).value();
  return part;
}

WalkPart Stand(double duration_s) {
  WalkPart part{StandingGait(4), {}};
  part.command.extent = WalkCommand::Extent::kDuration;
  part.command.duration_s = duration_s;
  return part;
}

Result<FootstepSkeleton> Plan(const std::vector<WalkPart>& parts) {
  return PlanSequence(NamedRobot("a1"), FlatTerrain(), parts, {});
}

/// Invariants of every skeleton of parts: phases abut, each stance has one foothold, parts follow each other from the
/// start to the end, and the base moves without a jump.
void ExpectLaws(const FootstepSkeleton& skeleton) {
  CheckSchedule(skeleton.schedule, 4);
  std::size_t stances = 0;
  for (int foot = 0; foot < 4; ++foot) {
    const auto intervals = IntervalsOf(skeleton.schedule, foot);
    stances += intervals.size();
    for (const ContactInterval& stance : intervals) {
      const auto& all = skeleton.footsteps.footholds;
      EXPECT_EQ(std::count_if(all.begin(), all.end(),
                              [&](const Foothold& f) {
                                return f.foot == foot && f.touchdown_s == stance.start_s && f.liftoff_s == stance.end_s;
                              }),
                1);
    }
  }
  EXPECT_EQ(stances, skeleton.footsteps.footholds.size());
  double since_s = skeleton.schedule.start_s();
  for (const MotionPart& part : skeleton.parts) {
    EXPECT_EQ(part.start_s, since_s);
    since_s = part.end_s;
  }
  EXPECT_EQ(since_s, skeleton.schedule.end_s());
  EXPECT_EQ(skeleton.parts.back().goal, skeleton.goal);
}

/// The base's speed along its path.
double SpeedAt(const FootstepSkeleton& skeleton, double time_s) {
  constexpr double kHalf = 0.01;
  const PlanarPose a = PoseAt(skeleton.path, time_s - kHalf), b = PoseAt(skeleton.path, time_s + kHalf);
  return std::hypot(b.x_m - a.x_m, b.y_m - a.y_m) / (2.0 * kHalf);
}

TEST(PlanSequence, OfOnePartIsThatOfPlanFootsteps) {
  const WalkPart trot = Part("trot", 0.5, 1.0);
  const FootstepSkeleton one = Plan({trot}).value();
  const FootstepSkeleton alone = PlanFootsteps(NamedRobot("a1"), FlatTerrain(), trot.gait, trot.command, {}).value();
  ExpectLaws(one);
  EXPECT_EQ(one.schedule, alone.schedule);
  EXPECT_EQ(one.path.pose, alone.path.pose);
}

TEST(PlanSequence, StandsWithItsFeetUnderTheBaseBetween) {
  const FootstepSkeleton skeleton = Plan({Part("trot", 1.0, 1.5), Stand(0.8), Part("bound", 0.8, 1.0)}).value();
  ExpectLaws(skeleton);
  ASSERT_EQ(skeleton.parts.size(), 3U);
  const MotionPart& stand = skeleton.parts[1];
  EXPECT_NEAR(stand.end_s - stand.start_s, 0.8, kSame);
  const PlanarPose there = PoseAt(skeleton.path, stand.start_s), still = PoseAt(skeleton.path, stand.end_s);
  constexpr double kAlmost = 1e-8;  // the path is straight between its samples
  EXPECT_NEAR(there.x_m, 1.5, kAlmost);
  EXPECT_NEAR(still.x_m, 1.5, kAlmost);
  const std::vector<Pose> standing = StandingFeet(NamedRobot("a1"));
  for (int foot = 0; foot < 4; ++foot) {
    const auto i = static_cast<std::size_t>(FootholdAt(skeleton.footsteps, foot, stand.start_s + 0.1));
    const Foothold& foothold = skeleton.footsteps.footholds[i];
    EXPECT_LE(foothold.touchdown_s, stand.start_s + kSame);
    EXPECT_GE(foothold.liftoff_s, stand.end_s - kSame);
    const Vector3 expected = Carried(there, standing[static_cast<std::size_t>(foot)]).translation();
    EXPECT_LT((foothold.X_WF.translation() - expected).norm(), 1e-6) << foot;
  }
  EXPECT_NEAR(skeleton.goal.x_m, 2.5, kAlmost);
}

TEST(PlanSequence, GoesOverFromOneGaitToAnotherWithoutStopping) {
  for (const bool faster : {true, false}) {
    const WalkPart slow = Part("crawl", 0.2, 0.6), fast = Part("trot", 0.7, 1.4);
    const FootstepSkeleton skeleton = Plan(faster ? std::vector{slow, fast} : std::vector{fast, slow}).value();
    ExpectLaws(skeleton);
    const double change = skeleton.parts[1].start_s;
    double least = 1e9, most = 0.0;
    for (double t = change - 1.0; t < change + 1.0; t += 0.01) {
      least = std::min(least, SpeedAt(skeleton, t));
      most = std::max(most, SpeedAt(skeleton, t));
      EXPECT_LT(std::abs(SpeedAt(skeleton, t + 0.01) - SpeedAt(skeleton, t)), 0.05) << t;
    }
    EXPECT_GT(least, 0.15);
    EXPECT_LT(most, 0.7 + 1e-3) << "no faster than asked";
    EXPECT_NEAR(skeleton.parts[0].goal.x_m, faster ? 0.6 : 1.4, kSame);
    EXPECT_NEAR(skeleton.path.pose.back().x_m, 2.0, kSame);
    // The faster gait changes the speed.
    EXPECT_LT(SpeedAt(skeleton, change), 0.3);
  }
}

TEST(PlanSequence, AtOneSpeedNothingOfItIsLost) {
  const FootstepSkeleton skeleton = Plan({Part("trot", 0.5, 1.0), Part("amble", 0.5, 1.0)}).value();
  ExpectLaws(skeleton);
  const double change = skeleton.parts[1].start_s;
  for (double t = change - 0.5; t < change + 0.5; t += 0.05) EXPECT_NEAR(SpeedAt(skeleton, t), 0.5, 0.08) << t;
}

TEST(PlanSequence, FollowsTurnsAndSideStepsFromWhereThePartBeforeLeads) {
  WalkPart turn = Part("trot", 0.0, 0.0), lateral = Part("trot", 0.0, 0.3);
  turn.command.yaw_rate_rad_s = 0.8;
  lateral.command.lateral_speed_m_s = 0.2;
  const FootstepSkeleton skeleton = Plan({turn, lateral, Part("trot", 0.4, 0.5)}).value();
  ExpectLaws(skeleton);
  // Turns by 90 degrees to the left, then moves 0.3 m to its left and 0.5 m forward.
  EXPECT_NEAR(skeleton.goal.x_m, -0.3, 1e-6);
  EXPECT_NEAR(skeleton.goal.y_m, 0.5, 1e-6);
  EXPECT_NEAR(skeleton.goal.yaw_rad, 0.5 * 3.14159265358979, 1e-6);
}

TEST(PlanSequence, CountedStepsLeadAsFarAsAlone) {
  WalkPart steps = Part("crawl", 0.0, 0.0);
  steps.command = {};
  steps.command.extent = WalkCommand::Extent::kSteps;
  steps.command.steps = 12;
  steps.command.step_length_m = 0.03;
  const FootstepSkeleton alone = Plan({steps}).value();
  const FootstepSkeleton skeleton = Plan({steps, Stand(0.5), Part("trot", 0.4, 0.5)}).value();
  ExpectLaws(skeleton);
  EXPECT_NEAR(skeleton.parts[0].goal.x_m, alone.goal.x_m, kSame);
  const double stand = skeleton.parts[1].start_s;
  const auto& all = skeleton.footsteps.footholds;
  EXPECT_EQ(std::count_if(all.begin(), all.end(),
                          [&](const Foothold& f) { return f.touchdown_s > 0.0 && f.touchdown_s <= stand + kSame; }),
            12);
  EXPECT_NEAR(PoseAt(skeleton.path, stand).x_m, alone.goal.x_m, 1e-6);
}

TEST(PlanSequence, WhatCannotBeNamesItsPart) {
  const auto why = [](const std::vector<WalkPart>& parts) {
    const auto skeleton = Plan(parts);
    return skeleton.ok() ? std::string() : skeleton.failure().message;
  };
  WalkPart goal = Part("trot", 0.4, 0.5);
  goal.command.extent = WalkCommand::Extent::kGoal;
  EXPECT_NE(why({Part("trot", 0.4, 0.5), goal}).find("part 2, 'trot': a part of a sequence cannot have a goal"),
            std::string::npos);
  EXPECT_NE(why({Stand(0.01), goal}).find("part 1, 'stand': the duration of standing still is 0.01 s"),
            std::string::npos);
}

TEST(PlanSequence, StandingIsEnough) {
  const auto skeleton = Plan({Stand(1.0), Stand(2.0)});
  ASSERT_TRUE(skeleton.ok()) << skeleton.failure().message;
  EXPECT_EQ(skeleton->schedule.phases.size(), 1U);
  EXPECT_NEAR(skeleton->schedule.end_s(), 3.0 + 2.0 * FootstepOptions{}.settling_s, 1e-9);
  ASSERT_EQ(skeleton->parts.size(), 2U);
  EXPECT_EQ(skeleton->footsteps.footholds.size(), 4U);
  EXPECT_LT(std::hypot(skeleton->goal.x_m, skeleton->goal.y_m), 1e-12);
}

}  // namespace
}  // namespace gaitwright
