// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/ik/leg_workspace.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "kinematics/base/result.h"
#include "kinematics/spatial/rotation.h"
#include "tests/kinematics/drawn.h"
#include "tests/kinematics/made_robots.h"

namespace gaitwright {
namespace {

constexpr double kWorkspaceMargin = 0.03;

/// Poses near the standing pose: up to a third of the leg away, with soles rotated and tilted a little.
std::vector<Pose> PosesAround(const Pose& X_BF, double leg_m, int count) {
  std::mt19937 engine(7);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  std::vector<Pose> poses;
  for (int i = 0; i < count; ++i) {
    Pose pose = X_BF;
    pose.translation() += leg_m / 3.0 * Drawn<Vector3>(unit, engine);
    pose.linear() = RotationExp(Vector3(0.25, 0.25, 0.375).cwiseProduct(Drawn<Vector3>(unit, engine))) * X_BF.linear();
    poses.push_back(pose);
  }
  return poses;
}

Pose Mirrored(const Pose& pose) {
  Matrix3 flip = Matrix3::Identity();
  flip(1, 1) = -1.0;
  Pose mirrored = Pose::Identity();
  mirrored.linear() = flip * pose.linear() * flip;
  mirrored.translation() = flip * pose.translation();
  return mirrored;
}

TEST(LegWorkspace, HoldsTheStandingPostureOfAnyRobotAndNothingBeyondTheLeg) {
  for (const char* name : kAnyRobots) {
    const RobotModel model = AnyRobot(name);
    for (int leg = 0; leg < static_cast<int>(model.legs.size()); ++leg) {
      LegWorkspace workspace(model, leg, kWorkspaceMargin);
      EXPECT_TRUE(workspace.Reaches(workspace.standing())) << name << " " << leg;
      Pose far = workspace.standing();
      far.translation().z() -= 2.0 * model.legs[static_cast<std::size_t>(leg)].length_m;
      EXPECT_FALSE(workspace.Reaches(far)) << name << " " << leg;
    }
  }
}

TEST(LegWorkspace, IsMirroredForLegsThatAre) {
  for (const char* name : {"a1", "nao"}) {
    const RobotModel model = AnyRobot(name);
    for (std::size_t leg = 0; leg < model.legs.size(); ++leg) {
      const int other = model.legs[leg].mirror;
      ASSERT_GE(other, 0);
      LegWorkspace here(model, static_cast<int>(leg), kWorkspaceMargin), there(model, other, kWorkspaceMargin);
      // Standing postures are mirrored to millimetres only, so a few poses near the boundary differ.
      int reached = 0, differ = 0;
      for (const Pose& away : PosesAround(Pose::Identity(), model.legs[leg].length_m, 2000)) {
        Pose pose = away * here.standing();
        pose.translation() = here.standing().translation() + away.translation();
        Pose image = Mirrored(away) * there.standing();
        image.translation() = there.standing().translation() + Mirrored(away).translation();
        reached += here.Reaches(pose) ? 1 : 0;
        differ += here.Reaches(pose) != there.Reaches(image) ? 1 : 0;
      }
      EXPECT_GT(reached, 200) << name;
      EXPECT_LT(reached, 2000) << name;
      EXPECT_LE(differ, 40) << name << " leg " << leg;
    }
  }
}

TEST(LegWorkspace, WhatItReachesInverseKinematicsReachesToo) {
  for (const char* name : {"a1", "nao", "line"}) {
    const RobotModel model = AnyRobot(name);
    const LegIk ik(model, 0);
    LegWorkspace workspace(model, 0, kWorkspaceMargin);
    int reached = 0;
    for (const Pose& pose : PosesAround(workspace.standing(), model.legs[0].length_m, 1500)) {
      if (!workspace.Reaches(pose)) continue;
      ++reached;
      EXPECT_TRUE(ik.Solve(pose).ok()) << name << ": " << ik.Solve(pose).failure().message;
    }
    EXPECT_GT(reached, 100) << name;
  }
}

TEST(LegWorkspace, DoesNotDependOnTheOrderOfQuestions) {
  const RobotModel model = AnyRobot("nao");
  LegWorkspace forward(model, 0, kWorkspaceMargin), backward(model, 0, kWorkspaceMargin);
  std::vector<Pose> poses = PosesAround(forward.standing(), model.legs[0].length_m, 6000);
  std::vector<bool> first;
  for (const Pose& pose : poses) first.push_back(forward.Reaches(pose));
  const int known = forward.size();
  for (std::size_t i = poses.size(); i-- > 0;) EXPECT_EQ(backward.Reaches(poses[i]), first[i]);
  for (std::size_t i = 0; i < poses.size(); ++i) EXPECT_EQ(forward.Reaches(poses[i]), first[i]);
  EXPECT_EQ(forward.size(), known);
  EXPECT_EQ(backward.size(), known);
}

TEST(LegWorkspace, AReserveLeavesLess) {
  const RobotModel model = AnyRobot("nao");
  LegWorkspace all(model, 0, 0.0), most(model, 0, 0.1);
  int with = 0, without = 0;
  for (const Pose& pose : PosesAround(all.standing(), model.legs[0].length_m, 1000)) {
    without += all.Reaches(pose) ? 1 : 0;
    with += most.Reaches(pose) ? 1 : 0;
    EXPECT_TRUE(all.Reaches(pose) || !most.Reaches(pose));
  }
  EXPECT_LT(with, without);
  EXPECT_GT(with, 0);
}

TEST(LegWorkspace, RefusesAReserveOutOfRange) {
  const RobotModel model = AnyRobot("a1");
  EXPECT_THROW(LegWorkspace(model, 0, -0.1), InvalidArgument);
  EXPECT_THROW(LegWorkspace(model, 0, 0.3), InvalidArgument);
  EXPECT_THROW(LegWorkspace(model, 9, 0.0), InvalidArgument);
}

TEST(LegWorkspaces, KeepOneOfEachLegAndMargin) {
  const RobotModel model = AnyRobot("nao");
  LegWorkspaces workspaces;
  LegWorkspace& left = workspaces.Of(model, 0, 0.03);
  left.Reaches(left.standing());
  const int known = left.size();
  EXPECT_EQ(&workspaces.Of(model, 0, 0.03), &left);
  EXPECT_NE(&workspaces.Of(model, 1, 0.03), &left);
  EXPECT_NE(&workspaces.Of(model, 0, 0.0), &left);
  EXPECT_EQ(left.size(), known);
  EXPECT_THROW(workspaces.Of(model, 9, 0.0), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
