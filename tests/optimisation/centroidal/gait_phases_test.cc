// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/centroidal/gait_phases.h"

#include <gtest/gtest.h>

#include "tests/optimisation/centroidal/rigid_bodies.h"

namespace gaitwright {
namespace {

TEST(SwitchTimes, AreWhereAnyContactChanges) {
  EXPECT_EQ(SwitchTimes(rigid_bodies::Hopper()), (std::vector<double>{0.0, 0.5, 0.75, 1.25}));
  EXPECT_EQ(SwitchTimes(rigid_bodies::Walker()), (std::vector<double>{0.0, 0.3, 0.55, 0.7, 1.0, 1.2, 1.45, 1.9}));
}

TEST(SwitchTimes, ThoseThatAreNearlyTheSameAreOne) {
  RigidBodyProblem problem = rigid_bodies::Trotter();
  const std::vector<double> switches = SwitchTimes(problem);
  EXPECT_EQ(switches, (std::vector<double>{0.0, 0.2, 0.45, 0.7, 0.95, 1.2, 1.4}));
  problem.stances[0].end_s += 0.5 * kSameSwitch_s;
  EXPECT_EQ(SwitchTimes(problem), switches);
  problem.stances[0].end_s += kSameSwitch_s;
  EXPECT_EQ(SwitchTimes(problem).size(), switches.size() + 1);
}

TEST(TimeMap, GoesStraightBetweenSwitchesAndBack) {
  const std::vector<double> from = {0.0, 0.5, 0.75, 1.25}, to = {0.0, 0.3, 1.0, 1.1};
  const TimeMap map(from, to), back(to, from);
  for (std::size_t i = 0; i < from.size(); ++i) EXPECT_EQ(map.At(from[i]), to[i]);
  EXPECT_DOUBLE_EQ(map.At(0.25), 0.15);
  EXPECT_DOUBLE_EQ(map.At(0.625), 0.65);
  for (double t = 0.0; t <= 1.25; t += 0.01) EXPECT_NEAR(back.At(map.At(t)), t, 1e-12);
  EXPECT_EQ(map.SwitchAt(0.5 + 0.5 * kSameSwitch_s), 0.3);
  EXPECT_EQ(map.SwitchAt(0.5 - 0.5 * kSameSwitch_s), 0.3);
  EXPECT_NE(map.At(0.5 + 0.5 * kSameSwitch_s), 0.3);
}

TEST(Retimed, AllThatHasATimeGoesWithIt) {
  RigidBodyProblem problem = rigid_bodies::Trotter();
  rigid_bodies::AddRolling(problem);
  problem.path = {{0.0, 0.45, 1.4}, std::vector<Vector3>(3), std::vector<Vector3>(3)};
  problem.stances[9].end_s = 0.2 + 0.5 * kSameSwitch_s;
  const std::vector<double> from = SwitchTimes(problem);
  std::vector<double> to = from;
  for (std::size_t i = 1; i < to.size(); ++i) to[i] = to[i - 1] + (i % 2 == 0 ? 0.7 : 1.4) * (from[i] - from[i - 1]);
  const RigidBodyProblem other = Retimed(problem, TimeMap(from, to));
  EXPECT_EQ(SwitchTimes(other), to);
  EXPECT_EQ(other.duration_s, to.back());
  EXPECT_EQ(other.stances[9].end_s, to[1]) << "one with the switch at 0.2 s";
  EXPECT_EQ(other.path.time_s, (std::vector<double>{0.0, to[2], to.back()}));
  for (std::size_t s = 0; s < problem.stances.size(); ++s) {
    const RigidStance &a = problem.stances[s], &b = other.stances[s];
    EXPECT_LT((a.MovedAt(0.5 * (a.start_s + a.end_s)) - b.MovedAt(0.5 * (b.start_s + b.end_s))).norm(), 1e-6);
  }
  EXPECT_NO_THROW(CheckRigidBodyProblem(other));
}

TEST(Retimed, WhatLegsDoAtGivenTimesIsNot) {
  EXPECT_TRUE(IsRetimable(rigid_bodies::Trotter()));
  RigidBodyProblem problem = rigid_bodies::Trotter();
  rigid_bodies::AddLegMotion(problem, 15);
  EXPECT_FALSE(IsRetimable(problem));
  problem = rigid_bodies::Trotter();
  rigid_bodies::AddMotors(problem, 100.0);
  EXPECT_FALSE(IsRetimable(problem));
}

}  // namespace
}  // namespace gaitwright
