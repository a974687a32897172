// SPDX-License-Identifier: BSD-3-Clause
// Analytical mechanics of one body on level ground or a slope, and of free flight, in each engine.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>

#include "kinematics/dynamics/dynamics.h"
#include "playback/play/make_world.h"
#include "tests/playback/one_body.h"
#include "tests/playback/one_joint.h"

namespace gaitwright {
namespace {

using one_body::Ball, one_body::Block, one_body::kMass, one_body::kRadius, one_body::OneBody, one_body::OnSlope;

class KnownAnswers : public testing::TestWithParam<std::string> {
 protected:
  std::unique_ptr<World> Make(const RobotModel& model, const VectorX& q, WorldOptions options = {}) const {
    options.engine = GetParam();
    return MakeWorld(model, FlatTerrain(), q, options);
  }

  /// A slope that descends along x.
  static WorldOptions Slope(double slope_rad, double friction) {
    WorldOptions options;
    options.ground_slope_deg = -slope_rad * 180.0 / M_PI;
    options.friction = friction;
    return options;
  }

  static void Run(World& world, int steps) {
    const VectorX none;
    for (int k = 0; k < steps; ++k) world.Step({none, none, none, none, none});
  }
};

TEST_P(KnownAnswers, TheDeepestContactIsNamedWithItsDepth) {
  const RobotModel ball = Ball();
  VectorX q = VectorX::Zero(7);
  q[6] = 1.0;
  q[2] = kRadius - 0.012;
  const auto world = Make(ball, q);
  const Penetration inside = world->DeepestPenetration();
  EXPECT_NEAR(inside.depth_m, 0.012, 1e-6);
  EXPECT_EQ(inside.link, "body");
  EXPECT_EQ(inside.solid, FlatTerrain().patches.front().name);
  q[2] = kRadius + 0.1;
  world->SetState(q, VectorX::Zero(6));
  EXPECT_EQ(world->DeepestPenetration(), Penetration{});
}

TEST_P(KnownAnswers, AnObstacleIsTheDeepestWhereItIs) {
  Terrain terrain = FlatTerrain();
  Obstacle post;
  post.name = "post";
  post.size_m = {0.2, 0.2, 0.4};
  post.X_WO.translation() = Vector3(0.17, 0.0, 0.2);
  terrain.obstacles = {post};
  const RobotModel ball = Ball();
  VectorX q = VectorX::Zero(7);
  q[6] = 1.0;
  q[2] = kRadius - 0.004;
  WorldOptions options;
  options.engine = GetParam();
  const auto world = MakeWorld(ball, terrain, q, options);
  const Penetration inside = world->DeepestPenetration();
  EXPECT_NEAR(inside.depth_m, 0.03, 1e-3);
  EXPECT_EQ(inside.solid, "post");
}

// Its two highest nodes are on the diagonal of the cell (see HeightField), so that the middle of the cell is as high.
TEST_P(KnownAnswers, ACellOfAHeightFieldIsARidgeWhereItsDiagonalIsHigh) {
  Terrain terrain;
  HeightField cell;
  cell.name = "cell";
  cell.columns = cell.rows = 2;
  cell.resolution_m = 1.0;
  cell.height_m = {1.0, 0.0, 0.0, 1.0};
  terrain.height_fields = {cell};
  const RobotModel ball = Ball();
  VectorX q = VectorX::Zero(7);
  q.head<3>() = Vector3(0.5, 0.5, 1.0 + kRadius - 0.01);
  q[6] = 1.0;
  WorldOptions options;
  options.engine = GetParam();
  const auto world = MakeWorld(ball, terrain, q, options);
  EXPECT_NEAR(world->DeepestPenetration().depth_m, 0.01, 0.005);
  q.z() += 0.02;
  world->SetState(q, VectorX::Zero(6));
  EXPECT_EQ(world->DeepestPenetration().depth_m, 0.0);
}

TEST_P(KnownAnswers, LookingForPenetrationChangesNothingThatFollows) {
  const RobotModel block = Block(0.2, 0.1, 0.3);
  VectorX q = VectorX::Zero(7);
  q[6] = 1.0;
  q[2] = 0.149;
  const auto looked = Make(block, q), plain = Make(block, q);
  (void)looked->DeepestPenetration();
  Run(*looked, 50);
  Run(*plain, 50);
  EXPECT_EQ(looked->q(), plain->q());
  EXPECT_EQ(looked->v(), plain->v());
}

// The contact point does not slide if friction is at least 2/7 tan(slope): a = 5/7 g sin(slope).
TEST_P(KnownAnswers, ABallRollsDownASlopeWithFiveSeventhsOfItsPull) {
  constexpr double kSlope = 0.2;
  const RobotModel ball = Ball();
  const auto world = Make(ball, OnSlope(kRadius, kSlope), Slope(kSlope, 0.8));
  Run(*world, 500);
  const double expected = 5.0 / 7.0 * kGravity * std::sin(kSlope) * 0.5;
  EXPECT_NEAR(world->v().head<3>().norm(), expected, 0.02 * expected);
  EXPECT_NEAR(world->v()[4], world->v().head<3>().norm() / kRadius, 0.02 * expected / kRadius);
}

// Sliding friction brakes it until it rolls. Its angular momentum about the ground is then still the initial one: 5/7
// v.
TEST_P(KnownAnswers, ABallThatSlidesEndsRollingAtFiveSevenths) {
  const RobotModel ball = Ball();
  WorldOptions options;
  options.friction = 0.3;
  const auto world = Make(ball, OnSlope(kRadius, 0.0), options);
  VectorX v = VectorX::Zero(6);
  v[0] = 1.4;
  world->SetState(world->q(), v);
  Run(*world, 100);
  EXPECT_NEAR(world->v()[0], 1.4 - 0.3 * kGravity * 0.1, 0.02);
  Run(*world, 500);
  EXPECT_NEAR(world->v()[0], 1.0, 0.01);
  EXPECT_NEAR(world->v()[4], 1.0 / kRadius, 0.1);
}

TEST_P(KnownAnswers, ABlockSlidesOnlyPastItsFrictionAngle) {
  constexpr double kFriction = 0.5;
  const RobotModel block = Block(0.4, 0.3, 0.05);
  const double angle = std::atan(kFriction);
  for (const double share : {0.95, 1.05}) {
    const double slope = share * angle;
    const auto world = Make(block, OnSlope(0.025, slope), Slope(slope, kFriction));
    Run(*world, 1000);
    const double pull = kGravity * (std::sin(slope) - kFriction * std::cos(slope));
    const double speed = world->v().head<3>().norm();
    EXPECT_NEAR(speed, std::max(pull, 0.0), 0.03) << share;
  }
}

// Gravity turns it over its lower edge once its centre is past the edge: tan(slope) = length / height.
TEST_P(KnownAnswers, ABlockTipsOnlyPastItsTippingAngle) {
  const RobotModel tower = Block(0.1, 0.1, 0.4);
  const double angle = std::atan(0.1 / 0.4);
  for (const double share : {0.95, 1.05}) {
    const double slope = share * angle;
    const auto world = Make(tower, OnSlope(0.2, slope), Slope(slope, 2.0));
    const Vector3 up = Quaternion(world->q().segment<4>(3)) * Vector3::UnitZ();
    Run(*world, 700);
    const Vector3 now = Quaternion(world->q().segment<4>(3)) * Vector3::UnitZ();
    const double turned = std::acos(std::clamp(up.dot(now), -1.0, 1.0));
    if (share < 1.0) {
      EXPECT_LT(turned, 0.01);
    } else {
      EXPECT_GT(turned, 0.2);
    }
  }
}

// m sqrt(2 g h), plus the impulse of the weight during the contact.
TEST_P(KnownAnswers, ADropLandsWithTheImpulseOfItsMomentum) {
  constexpr double kHeight = 0.2, kStep = 1e-3;
  const RobotModel ball = Ball();
  const auto world = Make(ball, OnSlope(kRadius + kHeight, 0.0));
  double impulse = 0.0;
  int steps = 0;
  for (; steps < 600; ++steps) {
    Run(*world, 1);
    impulse += kStep * world->feet()[0].wrench.force_W.z();
  }
  EXPECT_NEAR(world->v()[2], 0.0, 1e-3);
  EXPECT_NEAR(impulse, kMass * kGravity * kStep * steps, 0.01 * kMass * std::sqrt(2.0 * kGravity * kHeight));
}

// Motors give no torque. Gravity turns no body, so that momenta and the energy of rotation stay constant.
TEST_P(KnownAnswers, AHingeInFreeFallKeepsItsMomentumAndEnergy) {
  const RobotModel hinge = one_joint::Make(JointType::kRevolute);
  VectorX q = VectorX::Zero(8), v = VectorX::Zero(7);
  q[2] = 5.0;
  q[6] = 1.0;
  v << 0.3, -0.2, 1.0, 0.0, 0.0, 0.5, 2.0;
  const auto world = Make(hinge, q);
  world->SetState(q, v);
  const VectorX zero = VectorX::Zero(1);
  for (int k = 0; k < 500; ++k) world->Step({zero, zero, zero, zero, zero});
  EXPECT_NEAR(world->v()[0], v[0], 1e-6);
  EXPECT_NEAR(world->v()[2], v[2] - kGravity * 0.5, 1e-6);
  EXPECT_NEAR(world->v()[5], v[5], 1e-6);
  EXPECT_NEAR(world->v()[6], v[6], 1e-6);
  EXPECT_NEAR(world->q()[7], v[6] * 0.5, 1e-6);
}

// Two corners in front and one behind carry loads that balance the moments about their places.
TEST_P(KnownAnswers, ABodyOnThreePointsLoadsThemByTheLever) {
  RobotModel stool = OneBody({}, 0.02 * Matrix3::Identity());
  const Vector3 places[3] = {{0.3, 0.2, -0.2}, {0.3, -0.2, -0.2}, {-0.1, 0.0, -0.2}};
  stool.feet.clear();
  for (int i = 0; i < 3; ++i) {
    Foot foot;
    foot.name = foot.link = "leg" + std::to_string(i);
    foot.type = FootType::kPoint;
    foot.X_BF.translation() = places[i];
    stool.feet.push_back(foot);
  }
  const auto world = Make(stool, OnSlope(0.2, 0.0));
  Run(*world, 500);
  const double weight = kMass * kGravity, expected[3] = {0.125 * weight, 0.125 * weight, 0.75 * weight};
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(world->feet()[i].wrench.force_W.z(), expected[i], 0.01 * weight) << i;
}

TEST_P(KnownAnswers, ASofterContactSinksInByItsFactor) {
  const RobotModel ball = Ball();
  const auto depth = [&](double softness) {
    WorldOptions options;
    options.contact_softness = softness;
    const auto world = Make(ball, OnSlope(kRadius, 0.0), options);
    Run(*world, 2000);
    return kRadius - world->q()[2];
  };
  const double usual = depth(1.0), soft = depth(20.0);
  EXPECT_GT(usual, 0.0);
  EXPECT_NEAR(soft / usual, 20.0, 5.0);
}

INSTANTIATE_TEST_SUITE_P(Engines, KnownAnswers, testing::ValuesIn(EngineNames()),
                         [](const auto& engine) { return engine.param; });

}  // namespace
}  // namespace gaitwright
