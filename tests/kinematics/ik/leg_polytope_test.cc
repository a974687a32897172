// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/ik/leg_polytope.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/spatial/rotation.h"
#include "tests/kinematics/drawn.h"
#include "tests/kinematics/made_robots.h"
#include "tests/unusual_robots.h"

namespace gaitwright {
namespace {

constexpr double kReserve = 0.03, kFarthest = 0.6;  // share of the leg length
constexpr const char* kRobots[] = {"a1", "nao", "telescopic"};

RobotModel OneOf(const std::string& name) {
  if (name != "telescopic") return Robot(name);
  Result<RobotModel> model = LoadRobotFromText(unusual::Telescopic(), "");
  EXPECT_TRUE(model.ok()) << (model.ok() ? "" : model.failure().message);
  return std::move(model).value();
}

/// A leg with its workspace and polytope.
struct Tried {
  Tried(const RobotModel& model, int leg)
      : workspace(model, leg, kReserve),
        farthest_m(kFarthest * model.legs[static_cast<std::size_t>(leg)].length_m),
        up_B(BaseRotation(StandingConfiguration(model)).transpose() * Vector3::UnitZ()),
        sides(LegPolytope(workspace, farthest_m, up_B)) {}

  /// Distance of a point inside the polytope from its nearest side.
  double Inside(const Vector3& p_B) const {
    double least = std::numeric_limits<double>::infinity();
    for (const WorkspaceSide& side : sides) least = std::min(least, side.offset - side.normal.dot(p_B));
    return least;
  }
  Vector3 home() const { return workspace.standing().translation(); }

  /// Seeded random poses inside, with the rotation of the standing foot.
  std::vector<Pose> Drawn(int count) const {
    std::mt19937 engine(11);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    std::vector<Pose> poses;
    while (static_cast<int>(poses.size()) < count) {
      Pose pose = workspace.standing();
      for (int axis = 0; axis < 3; ++axis) pose.translation()[axis] += farthest_m * unit(engine);
      if (Inside(pose.translation()) >= 0.0) poses.push_back(pose);
    }
    return poses;
  }

  LegWorkspace workspace;
  double farthest_m;
  Vector3 up_B;
  std::vector<WorkspaceSide> sides;
};

/// One leg of each robot is enough, because the other is its mirror image.
template <class Check>
void ForEachKindOfLeg(const Check& check) {
  for (const char* name : kRobots) {
    const RobotModel model = OneOf(name);
    for (int leg = 0; leg < static_cast<int>(model.legs.size()); leg += 2) {
      SCOPED_TRACE(std::string(name) + " leg " + std::to_string(leg));
      Tried tried(model, leg);
      check(tried);
    }
  }
}

TEST(LegPolytope, TheStandingPlaceIsInsideAndSidesAreNoFartherThanAsked) {
  ForEachKindOfLeg([](const Tried& tried) {
    EXPECT_GE(tried.Inside(tried.home()), 0.02 * tried.farthest_m - 1e-12);
    EXPECT_LT(tried.sides.size(), 27U);
    for (const WorkspaceSide& side : tried.sides) {
      EXPECT_NEAR(side.normal.norm(), 1.0, 1e-12);
      EXPECT_LE(side.offset - side.normal.dot(tried.home()), tried.farthest_m + 1e-12);
    }
  });
}

/// The workspace may have dents between the tested rays, so at least 97 % of the points must be reached.
TEST(LegPolytope, WhatIsInItIsReachedAndItIsAFairPartOfThat) {
  ForEachKindOfLeg([](Tried& tried) {
    constexpr int kCount = 400;
    int reached = 0;
    for (const Pose& pose : tried.Drawn(kCount)) reached += tried.workspace.Reaches(pose) ? 1 : 0;
    EXPECT_GE(reached, kCount * 97 / 100);
    std::mt19937 engine(13);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    int reachable = 0, inside = 0;
    for (int i = 0; i < 2000; ++i) {
      Pose pose = tried.workspace.standing();
      for (int axis = 0; axis < 3; ++axis) pose.translation()[axis] += tried.farthest_m * unit(engine);
      if (!tried.workspace.Reaches(pose)) continue;
      ++reachable;
      inside += tried.Inside(pose.translation()) >= 0.0 ? 1 : 0;
    }
    EXPECT_GT(inside, reachable / 17);
    EXPECT_LT(inside, reachable);
  });
}

/// Balls that are high above the foot in standing must stay above a tenth of the farthest distance.
TEST(LegPolytope, TheKneeStaysAboveTheGround) {
  for (const char* name : {"a1", "nao"}) {
    Tried tried(Robot(name), 0);
    std::vector<Ball> balls;
    ASSERT_TRUE(tried.workspace.BallsAt(tried.workspace.standing(), balls));
    const auto height = [&](const Ball& ball, const Pose& X_BF) {
      return tried.up_B.dot(ball.centre_B - X_BF.translation()) - ball.radius_m;
    };
    std::vector<bool> high;
    for (const Ball& ball : balls) high.push_back(height(ball, tried.workspace.standing()) > 0.2 * tried.farthest_m);
    ASSERT_TRUE(std::find(high.begin(), high.end(), true) != high.end());
    const auto lowest = [&](const Pose& pose) {
      double least = tried.farthest_m;
      if (!tried.workspace.BallsAt(pose, balls)) return least;
      for (std::size_t i = 0; i < balls.size(); ++i) {
        if (high[i]) least = std::min(least, height(balls[i], pose));
      }
      return least;
    };
    for (const Pose& pose : tried.Drawn(400)) EXPECT_GT(lowest(pose), 0.095 * tried.farthest_m) << name;
    if (std::string(name) == "nao") continue;  // its knees are high for all positions of the feet
    std::mt19937 engine(17);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    double least = tried.farthest_m;
    for (int i = 0; i < 1000; ++i) {
      Pose pose = tried.workspace.standing();
      pose.translation() += tried.farthest_m * Drawn<Vector3>(unit, engine);
      if (tried.workspace.Reaches(pose)) least = std::min(least, lowest(pose));
    }
    EXPECT_LT(least, 0.0) << "the leg alone would take it there";
  }
}

/// Legs are mirrored only to millimetres, so a ray may end one step farther or nearer. This moves one side of A1 by 20
/// mm, because in the mirror image another side limits the ray first.
TEST(LegPolytope, IsMirroredForLegsThatAre) {
  for (const char* name : {"a1", "nao"}) {
    const RobotModel model = Robot(name);
    for (int leg = 0; leg < static_cast<int>(model.legs.size()); leg += 2) {
      const int other = model.legs[static_cast<std::size_t>(leg)].mirror;
      ASSERT_GE(other, 0);
      const Tried here(model, leg), there(model, other);
      ASSERT_EQ(here.sides.size(), there.sides.size());
      const double step_m = 0.02 * here.farthest_m;
      int apart = 0;
      for (const WorkspaceSide& side : here.sides) {
        const Vector3 image(side.normal.x(), -side.normal.y(), side.normal.z());
        const auto same = std::find_if(there.sides.begin(), there.sides.end(),
                                       [&](const WorkspaceSide& s) { return (s.normal - image).norm() < 1e-9; });
        ASSERT_NE(same, there.sides.end()) << name << " leg " << leg;
        EXPECT_NEAR(side.offset, same->offset, 0.1 * here.farthest_m) << name << " leg " << leg;
        apart += std::abs(side.offset - same->offset) > step_m ? 1 : 0;
      }
      EXPECT_LE(apart, 1) << name << " leg " << leg;
    }
  }
}

}  // namespace
}  // namespace gaitwright
