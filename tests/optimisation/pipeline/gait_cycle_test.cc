// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/pipeline/gait_cycle.h"

#include <gtest/gtest.h>

#include <cmath>

#include "kinematics/model/load_robot.h"
#include "optimisation/centroidal/gait_phases.h"
#include "optimisation/pipeline/robot_body.h"
#include "optimisation/whole_body/body_path.h"
#include "planning/footsteps/plan_sequence.h"
#include "planning/gait/find_gait.h"

namespace gaitwright {
namespace {

const RobotModel& A1() {
  static const RobotModel model = *LoadNamedRobot("a1");
  return model;
}

Gait GaitOf(const std::string& name) { return *FindGait(A1(), name, 0.5, {}); }

/// A walk of three cycles, and the contact switches of its problem.
struct TiedWalk {
  const RobotModel& model = A1();
  Gait gait;
  FootstepSkeleton skeleton;
  std::vector<double> switches_s;

  explicit TiedWalk(const std::string& name) {
    gait = GaitOf(name);
    WalkCommand command;
    command.speed_m_s = 0.5;
    command.distance_m = 1.5 * gait.cycle_s;
    skeleton = *PlanFootsteps(model, FlatTerrain(), gait, command, {});
    const BodyPath path(model, skeleton, gait.cycle_s);
    switches_s = SwitchTimes(ProblemOf(model, BodyOf(model, 0.03), FlatTerrain(), skeleton, path));
  }

  std::optional<CycleTies> Ties() const { return TiesOf(skeleton, 0, switches_s, 0.005); }
};

double OffOf(double a, double b) { return std::abs(a - b - std::round(a - b)); }

TEST(GaitCycle, PartsAreACycleAndGiveTheSameGaitBack) {
  for (const char* name : {"trot", "bound", "gallop", "pronk", "pace", "amble", "crawl"}) {
    const Gait gait = GaitOf(name);
    const GaitCycle cycle(gait, 0);
    EXPECT_NEAR(cycle.repeats() * cycle.durations_s().sum(), gait.cycle_s, 1e-12) << name;
    EXPECT_GT(cycle.durations_s().minCoeff(), 0.0);
    const Gait same = cycle.With(cycle.durations_s());
    EXPECT_NEAR(same.cycle_s, gait.cycle_s, 1e-12);
    for (std::size_t i = 0; i < gait.phase.size(); ++i) {
      EXPECT_NEAR(same.duty_factor[i], gait.duty_factor[i], 1e-9) << name;
      EXPECT_LT(OffOf(same.phase[i] - same.phase[0], gait.phase[i] - gait.phase[0]), 1e-9) << name;
    }
  }
}

TEST(GaitCycle, OtherDurationsMoveLiftOffsAndTouchDowns) {
  Gait bound = GaitOf("bound");
  EXPECT_EQ(GaitCycle(bound, 2).repeats(), 2) << "fore feet do as hind feet do";
  bound.duty_factor = {0.375, 0.375, 0.36, 0.36};
  const GaitCycle cycle(bound, 2);
  EXPECT_EQ(cycle.repeats(), 1);
  ASSERT_EQ(cycle.durations_s().size(), 4) << "two stances and two flights";
  VectorX durations = cycle.durations_s();
  EXPECT_NEAR(durations[0], (0.5 - bound.duty_factor[2]) * bound.cycle_s, 1e-9) << "a flight begins it";
  durations[0] -= 0.02;
  durations[1] += 0.02;
  const Gait other = cycle.With(durations);
  EXPECT_NEAR(other.cycle_s, bound.cycle_s, 1e-12);
  for (const std::size_t fore : {0U, 1U})
    EXPECT_NEAR(other.duty_factor[fore], bound.duty_factor[fore] + 0.02 / bound.cycle_s, 1e-9);
  for (const std::size_t hind : {2U, 3U}) EXPECT_NEAR(other.duty_factor[hind], bound.duty_factor[hind], 1e-9);
  EXPECT_LT(OffOf(other.phase[0] - other.phase[2], bound.phase[0] - bound.phase[2] - 0.02 / bound.cycle_s), 1e-9);
}

TEST(GaitCycle, WhatRepeatsItselfWithOtherFeetStillDoes) {
  const struct {
    const char* name;
    int repeats, parts;
  } kCases[] = {{"trot", 2, 2}, {"bound", 2, 2}, {"gallop", 2, 4}, {"pronk", 1, 2}, {"crawl", 4, 2}};
  for (const auto& [name, repeats, parts] : kCases) {
    const Gait gait = GaitOf(name);
    const GaitCycle cycle(gait, 0);
    EXPECT_EQ(cycle.repeats(), repeats) << name;
    EXPECT_EQ(cycle.durations_s().size(), parts) << name;
    VectorX durations = cycle.durations_s();
    durations[0] += 0.01;
    durations[1] -= 0.01;
    const Gait other = cycle.With(durations);
    EXPECT_NEAR(other.cycle_s, gait.cycle_s, 1e-12);
    const GaitCycle again(other, 0);
    EXPECT_EQ(again.repeats(), repeats) << name;
  }
}

TEST(GaitCycle, NoSwingBecomesShorterThanItMay) {
  for (const char* name : {"gallop", "pronk", "bound"}) {
    const GaitCycle cycle(GaitOf(name), 0);
    const VectorX swing = cycle.TouchDown(0, 0) - cycle.LiftOff(0, 0);
    const VectorX& given = cycle.durations_s();
    VectorX hurried = given;
    for (Eigen::Index k = 0; k < given.size(); ++k) hurried[k] *= swing[k] > 0.0 ? 0.5 : 1.5;
    const double share = cycle.ShareKeepingSwings(hurried, 0.0, 0.7);
    ASSERT_GT(share, 0.0) << name;
    ASSERT_LT(share, 1.0) << name;
    double least = 1e9;
    for (int foot = 0; foot < 4; ++foot) {
      const VectorX in = cycle.TouchDown(foot, 0) - cycle.LiftOff(foot, 0);
      least = std::min(least, in.dot(given + share * (hurried - given)) / in.dot(given));
    }
    EXPECT_NEAR(least, 0.7, 1e-9) << name;
    EXPECT_EQ(cycle.ShareKeepingSwings(hurried, 10.0, 0.0), 0.0) << "what is given shorter becomes no shorter";
    EXPECT_EQ(cycle.ShareKeepingSwings(given, 10.0, 1.0), 1.0);
  }
}

TEST(TiesOf, PhasesOfAWalkFollowTheCycle) {
  for (const char* name : {"trot", "bound", "gallop", "pronk"}) {
    const TiedWalk walk(name);
    const std::optional<CycleTies> tied = walk.Ties();
    ASSERT_TRUE(tied) << name;
    const PhaseTies& ties = tied->ties;
    const VectorX durations = ties.phases_by_parts * ties.parts_s + ties.rest_s;
    for (Eigen::Index k = 0; k < durations.size(); ++k) {
      const auto i = static_cast<std::size_t>(k);
      EXPECT_NEAR(durations[k], walk.switches_s[i + 1] - walk.switches_s[i], 1e-12) << name;
      if (k > 0 && k + 1 < durations.size()) {
        EXPECT_LT(std::abs(ties.rest_s[k]), 0.011) << name << ": what times are rounded by";
        EXPECT_GT(ties.phases_by_parts.row(k).sum(), 0.5) << name;
      }
    }
    EXPECT_TRUE(ties.phases_by_parts.row(0).isZero()) << "standing stays";
    EXPECT_TRUE(ties.phases_by_parts.colwise().sum().isZero()) << "the whole time stays";
  }
}

/// A walk with the gait at other times has the phases that the ties predict.
TEST(TiesOf, ForetellTheScheduleOfTheOtherGait) {
  TiedWalk walk("bound");
  const std::optional<CycleTies> tied = walk.Ties();
  ASSERT_TRUE(tied);
  VectorX parts = tied->ties.parts_s;
  parts[0] -= 0.015;
  parts[1] += 0.015;
  ASSERT_EQ(parts.size(), 2);
  const VectorX durations = tied->ties.phases_by_parts * parts + tied->ties.rest_s;
  WalkCommand command = walk.skeleton.parts.front().command;
  const FootstepSkeleton other = *PlanFootsteps(walk.model, FlatTerrain(), tied->cycle.With(parts), command, {});
  ASSERT_EQ(static_cast<Eigen::Index>(other.schedule.phases.size()), durations.size());
  double time_s = 0.0;
  for (Eigen::Index k = 0; k + 1 < durations.size(); ++k) {
    time_s += durations[k];
    EXPECT_NEAR(other.schedule.phases[static_cast<std::size_t>(k)].end_s, time_s, 0.011);
  }
}

TEST(TiesOf, AreNoneOfContactsThatAreNotThoseOfTheGait) {
  TiedWalk walk("bound");
  walk.skeleton.parts.front().gait.cycle_s *= 1.3;
  EXPECT_FALSE(walk.Ties());
}

}  // namespace
}  // namespace gaitwright
