// SPDX-License-Identifier: BSD-3-Clause
#include "planning/footsteps/stance_check.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <set>
#include <string>
#include <utility>

#include "kinematics/spatial/rotation.h"
#include "planning/gait/find_gait.h"
#include "planning/paths/standing_feet.h"
#include "tests/named_robot.h"
#include "tests/planning/footsteps/grounds.h"

namespace gaitwright {
namespace {

FootstepQuery StanceQuery(const RobotModel& model) {
  return {FindGait(model, "", 0.2, {}).value(), RouteAlong({1.0, 0.0, 0.0}, 0.2), 0.2};
}

/// The reason why a robot cannot stand in its standing stance after a change.
StanceFault FaultWith(const RobotModel& model, const Terrain& terrain,
                      const std::function<void(std::vector<Pose>&)>& change = {}, FootstepQuery query = {},
                      const FootstepSearchOptions& options = {}) {
  if (query.gait.phase.empty()) query = StanceQuery(model);
  const GroundIndex ground(terrain, 0.5 * model.leg_length_m());
  const FootholdChecker footholds(model, ground, {});
  StanceChecker checker(model, ground, query, {}, options);
  std::vector<Pose> X_WF = StandingFeet(model);
  if (change) change(X_WF);
  std::vector<Polygon> outlines;
  for (std::size_t f = 0; f < X_WF.size(); ++f) {
    const Vector3 p = X_WF[f].translation();
    outlines.push_back(footholds.OutlineAt(static_cast<int>(f), {p.x(), p.y(), YawOf(X_WF[f].linear())}));
  }
  std::vector<const Polygon*> seen;
  for (const Polygon& outline : outlines) seen.push_back(&outline);
  return checker.Check(X_WF, seen);
}

class StanceCheckTest : public testing::TestWithParam<const char*> {};

TEST_P(StanceCheckTest, StandingHoldsWhereverTheFeetAre) {
  const RobotModel& model = NamedRobot(GetParam());
  EXPECT_EQ(FaultWith(model, FlatTerrain()), StanceFault::kNone);
  EXPECT_EQ(FaultWith(model, FlatTerrain(),
                      [](auto& X_WF) {
                        for (Pose& X : X_WF) X.translation() += Vector3(5.0, -3.0, 0.0);
                      }),
            StanceFault::kNone);
  EXPECT_EQ(FaultWith(model, FlatTerrain(),
                      [](auto& X_WF) {
                        const Matrix3 R = Eigen::AngleAxisd(1.0, Vector3::UnitZ()).toRotationMatrix();
                        for (Pose& X : X_WF) X = Pose(Eigen::Translation3d(0.3, 0.2, 0.0)) * Pose(R) * X;
                      }),
            StanceFault::kNone);
}

TEST_P(StanceCheckTest, CrossedFeetAreTooClose) {
  EXPECT_EQ(FaultWith(NamedRobot(GetParam()), FlatTerrain(), [](auto& X_WF) { std::swap(X_WF[0], X_WF[1]); }),
            StanceFault::kFeetClose);
}

TEST_P(StanceCheckTest, FeetOnTopOfEachOtherAreTooClose) {
  EXPECT_EQ(FaultWith(NamedRobot(GetParam()), FlatTerrain(),
                      [](auto& X_WF) {
                        const double middle = 0.5 * (X_WF[0].translation().y() + X_WF[1].translation().y());
                        X_WF[0].translation().y() = middle + 0.005;
                        X_WF[1].translation().y() = middle - 0.005;
                      }),
            StanceFault::kFeetClose);
}

TEST_P(StanceCheckTest, AFootALegLengthForwardIsOutOfReach) {
  const RobotModel& model = NamedRobot(GetParam());
  EXPECT_EQ(
      FaultWith(model, FlatTerrain(), [&](auto& X_WF) { X_WF[0].translation().x() += 2.5 * model.leg_length_m(); }),
      StanceFault::kReach);
}

TEST_P(StanceCheckTest, ABodyThatMayNotBeThereIsRefused) {
  const RobotModel& model = NamedRobot(GetParam());
  FootstepQuery query = StanceQuery(model);
  query.body_free = [](const PlanarPose& base, double ground_m) { return base.x_m < 1.0 && ground_m < 0.5; };
  EXPECT_EQ(FaultWith(model, FlatTerrain(), {}, query), StanceFault::kNone);
  const auto forward = [](auto& X_WF) {
    for (Pose& X : X_WF) X.translation().x() += 2.0;
  };
  EXPECT_EQ(FaultWith(model, FlatTerrain(), forward, query), StanceFault::kBodyObstacle);
}

TEST_P(StanceCheckTest, AnObstacleAtTheBodysPlaceIsHitUnlessItIsOverheadOrStepped) {
  const RobotModel& model = NamedRobot(GetParam());
  const double leg = model.leg_length_m();
  const auto with_block = [&](double bottom_m, double top_m) {
    Terrain terrain = FlatTerrain();
    Obstacle block;
    block.name = "block";
    block.X_WO.translation() = Vector3(0.0, 0.0, 0.5 * (bottom_m + top_m));
    block.size_m = Vector3(0.02, 0.02, top_m - bottom_m);
    terrain.obstacles = {block};
    return FaultWith(model, terrain);
  };
  EXPECT_EQ(with_block(0.0, 2.0), StanceFault::kBodyObstacle);
  EXPECT_EQ(with_block(0.0, 0.1 * leg), StanceFault::kNone) << "stepped over";
  EXPECT_EQ(with_block(5.0, 6.0), StanceFault::kNone) << "overhead";
}

INSTANTIATE_TEST_SUITE_P(Robots, StanceCheckTest, testing::Values("a1", "nao"));

TEST(StanceCheck, ARaisedHeelReachesALowerStep) {
  const RobotModel& model = NamedRobot("g1");
  const auto down = [&](std::vector<Pose>& X_WF) {
    X_WF[0].translation().x() += 0.155;
    X_WF[1].translation().z() += 0.17;
  };
  FootstepSearchOptions options;
  options.reserve = 0.0;
  EXPECT_EQ(FaultWith(model, FlatTerrain(), down, {}, options), StanceFault::kReach);
  options.heel_off_rad = 0.5;
  EXPECT_EQ(FaultWith(model, FlatTerrain(), down, {}, options), StanceFault::kNone);
}

TEST(StanceCheck, FeetOnATooSteepPlaneTiltTheBody) {
  const RobotModel& a1 = NamedRobot("a1");
  const auto fault = [&](double slope) {
    return FaultWith(a1, FlatTerrain(), [&](auto& X_WF) {
      for (Pose& X : X_WF) X.translation().z() = slope * X.translation().x();
    });
  };
  EXPECT_EQ(fault(std::tan(0.75)), StanceFault::kTilt) << "43 degrees";
  EXPECT_NE(fault(std::tan(0.65)), StanceFault::kTilt) << "37 degrees";
}

TEST(StanceCheck, ABlockUnderTheBellyMakesTheBodyLow) {
  const RobotModel& a1 = NamedRobot("a1");
  Terrain terrain = FlatTerrain();
  terrain.patches.push_back(Rectangle("block", {-0.08, -0.04}, {0.08, 0.04}, a1.standing_base_height_m));
  EXPECT_EQ(FaultWith(a1, terrain), StanceFault::kBodyLow);
  terrain.patches.back().X_WT.translation().z() = 0.02;
  EXPECT_EQ(FaultWith(a1, terrain), StanceFault::kNone);
}

TEST(StanceCheck, TheBaseGoesWithItsFeet) {
  const RobotModel& a1 = NamedRobot("a1");
  const Terrain flat = FlatTerrain();
  const GroundIndex ground(flat, 0.2);
  const FootstepQuery query = StanceQuery(a1);
  const StanceChecker checker(a1, ground, query, {}, {});
  EXPECT_EQ(checker.standing().size(), 4U);
  std::vector<Pose> X_WF = StandingFeet(a1);
  for (Pose& X : X_WF) X.translation() += Vector3(0.7, -0.2, 0.1);
  const BaseOverFeet base = checker.BaseOf(X_WF);
  EXPECT_NEAR(base.plan.x_m, 0.7, 1e-9);
  EXPECT_NEAR(base.plan.y_m, -0.2, 1e-9);
  EXPECT_NEAR(base.plan.yaw_rad, 0.0, 1e-9);
  EXPECT_NEAR(base.ground_m, 0.1, 1e-9);
}

TEST(LoneSoles, AreThoseThatStandAloneWhileAllOtherFeetSwing) {
  const RobotModel &nao = NamedRobot("nao"), &a1 = NamedRobot("a1");
  EXPECT_EQ(LoneSoles(nao, FindGait(nao, "walk", 0.1, {}).value()), (std::vector<int>{0, 1}));
  EXPECT_TRUE(LoneSoles(a1, FindGait(a1, "trot", 0.3, {}).value()).empty());
  EXPECT_TRUE(LoneSoles(a1, FindGait(a1, "crawl", 0.1, {}).value()).empty());
}

TEST(StanceFaults, EachHasItsOwnWords) {
  std::set<std::string> words;
  for (int fault = 0; fault <= static_cast<int>(StanceFault::kBodyObstacle); ++fault)
    EXPECT_TRUE(words.insert(Describe(static_cast<StanceFault>(fault))).second) << fault;
  EXPECT_FALSE(words.contains(""));
}

}  // namespace
}  // namespace gaitwright
