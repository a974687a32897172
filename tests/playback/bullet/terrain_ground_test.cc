// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "kinematics/base/result.h"
#include "planning/plan/built_in_terrain.h"
#include "playback/bullet/bullet_world.h"
#include "playback/bullet/ground_internal.h"
#include "playback/bullet/robot_body_internal.h"
#include "playback/control/joint_pd.h"
#include "tests/playback/standing_plan.h"

namespace gaitwright {
namespace {

/// A terrain in Bullet without a robot, for casting rays.
class RayWorld {
 public:
  explicit RayWorld(const Terrain& terrain)
      : dispatcher_(&configuration_),
        world_(&dispatcher_, &broadphase_, &configuration_),
        ground_(terrain, WorldOptions{}, Bumps()) {
    ground_.AddTo(world_);
  }
  ~RayWorld() {
    for (int i = world_.getNumCollisionObjects() - 1; i >= 0; --i)
      world_.removeCollisionObject(world_.getCollisionObjectArray()[i]);
  }

  /// Height and normal of the first hit of a ray straight down; the height is not finite without a hit.
  std::pair<double, Vector3> Below(const Vector2& p, double from_z = 3.0) {
    const btVector3 from(p.x(), p.y(), from_z), to(p.x(), p.y(), -3.0);
    btCollisionWorld::ClosestRayResultCallback hit(from, to);
    hit.m_collisionFilterGroup = btBroadphaseProxy::CharacterFilter;
    hit.m_collisionFilterMask = btBroadphaseProxy::StaticFilter;
    world_.rayTest(from, to, hit);
    if (!hit.hasHit()) return {std::nan(""), Vector3::Zero()};
    return {hit.m_hitPointWorld.z(), bullet::FromBullet(hit.m_hitNormalWorld)};
  }

 private:
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broadphase_;
  btCollisionWorld world_;
  bullet::Ground ground_;
};

TEST(TerrainInBullet, HeightFieldsAreTheTerrainsOwnTriangles) {
  Terrain terrain{"", {}, {{"field", {-0.4, 0.3}, 0.05, 31, 23, {}, 0.8}}, {}};
  HeightField& field = terrain.height_fields[0];
  std::mt19937 engine(3);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (int i = 0; i < field.columns * field.rows; ++i) field.height_m.push_back(0.05 * share(engine));
  RayWorld world(terrain);
  for (int i = 0; i < 2000; ++i) {
    const Vector2 p = field.origin_W + 0.05 * Vector2(30.0 * share(engine), 22.0 * share(engine));
    const GroundPoint ground = GroundAt(terrain, p);
    const auto [height, normal] = world.Below(p);
    ASSERT_NEAR(height, ground.height_m, 1e-9) << p.transpose();
    ASSERT_LT((normal - ground.normal_W).norm(), 1e-6) << p.transpose();
  }
  EXPECT_TRUE(std::isnan(world.Below(field.origin_W - Vector2(0.01, 0.01)).first));
}

class BuiltInInBullet : public ::testing::TestWithParam<std::string> {};

TEST_P(BuiltInInBullet, TheGroundIsWhereTheTerrainSays) {
  const Terrain terrain = *MakeTerrain(GetParam(), {});
  RayWorld world(terrain);
  std::mt19937 engine(5);
  std::uniform_real_distribution<double> x(0.0, 4.0), y(-1.0, 1.0);
  int compared = 0;
  for (int i = 0; i < 400; ++i) {
    const Vector2 p(x(engine), y(engine));
    constexpr double kEdge = 0.003;  // Bullet's edges are rounded by its margin
    const GroundPoint ground = GroundAt(terrain, p);
    bool even = true;
    for (const Vector2& by : {Vector2(kEdge, 0), Vector2(-kEdge, 0), Vector2(0, kEdge), Vector2(0, -kEdge)})
      even = even && GroundAt(terrain, p + by).patch == ground.patch;
    const auto [height, normal] = world.Below(p);
    const bool roofed = std::any_of(terrain.obstacles.begin(), terrain.obstacles.end(), [&](const Obstacle& o) {
      const Vector2 from = (p - o.X_WO.translation().head<2>()).cwiseAbs() - 0.5 * o.size_m.head<2>();
      return from.maxCoeff() < kEdge;
    });
    if (!even || roofed) continue;
    ++compared;
    if (ground.patch < 0) {
      EXPECT_TRUE(std::isnan(height)) << p.transpose();
    } else {
      EXPECT_NEAR(height, ground.height_m, 1e-4) << p.transpose();
      EXPECT_LT((normal - ground.normal_W).norm(), 1e-2) << p.transpose();
    }
  }
  EXPECT_GT(compared, 200);
  for (const Obstacle& obstacle : terrain.obstacles) {
    const Vector3 p = obstacle.X_WO.translation();
    EXPECT_NEAR(world.Below(p.head<2>(), 10.0).first, p.z() + 0.5 * obstacle.size_m.z(), 1e-3) << obstacle.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, BuiltInInBullet,
                         ::testing::Values("slope", "stairs", "block", "gap", "stepping-stones", "beam", "rough",
                                           "cinder-blocks", "ramp", "corridor", "doorway", "maze"),
                         [](const auto& i) {
                           std::string name = i.param;
                           for (char& c : name) c = c == '-' ? '_' : c;
                           return name;
                         });

TEST(TerrainInBullet, AnObstacleOfAnyKindIsSolid) {
  Terrain terrain = FlatTerrain();
  Obstacle post;
  post.name = "post";
  post.type = ShapeType::kCylinder;
  post.X_WO.translation() << 1.0, 0.0, 0.25;
  post.size_m << 0.1, 0.5, 0.0;
  Obstacle wedge;
  wedge.name = "wedge";
  wedge.type = ShapeType::kMesh;
  wedge.vertices_O = {{2, -1, 0}, {2, 1, 0}, {4, -1, 0}, {4, 1, 0}, {4, -1, 1}, {4, 1, 1}};
  terrain.obstacles = {post, wedge};
  RayWorld world(terrain);
  EXPECT_NEAR(world.Below({1.05, 0.05}).first, 0.5, 1e-3);
  EXPECT_NEAR(world.Below({1.08, 0.08}).first, 0.0, 1e-3);
  EXPECT_NEAR(world.Below({3.0, 0.3}).first, 0.5, 1e-3);
  terrain.obstacles[1].vertices_O.clear();
  EXPECT_THROW(RayWorld{terrain}, InvalidArgument);
}

TEST(TerrainInBullet, ABodyThatTouchesAnObstacleIsSeenToTouch) {
  const RobotModel model = standing::Load("a1");
  const TerrainScale scale = ScaleOf(model);
  for (const double beside : {-0.005, 0.02}) {
    Terrain terrain = FlatTerrain();
    Obstacle wall;
    wall.name = "wall";
    wall.X_WO.translation() << scale.front_m + beside + 0.05, 0.0, 0.5;
    wall.size_m << 0.1, 2.0, 1.0;
    terrain.obstacles = {wall};
    const MotionPlan plan = standing::Plan(model, 1.0);
    BulletWorld world(model, terrain, plan.whole_body.q.front(), {});
    JointPd controller(model, plan);
    bool touched = false;
    for (int k = 0; k < 20; ++k) {
      world.Step(controller.Update({}));
      touched = touched || !world.body_contacts().empty();
    }
    EXPECT_EQ(touched, beside < 0.0);
  }
}

/// The first x from `from` on at which all feet of the standing robot, with its base over (x, 0), have ground under
/// their whole soles at nearly one height; and the height at which it stands. Its z axis is along `normal`.
struct Place {
  VectorX q;
  double height_m = 0.0;
};

Place FindPlace(const RobotModel& model, const Terrain& terrain, double from, bool tilted) {
  DynamicsScratch scratch(model);
  for (double x = from; x < from + 2.0; x += 0.005) {
    Place place{StandingConfiguration(model), -1e9};
    const Vector3 normal = tilted ? GroundAt(terrain, {x, 0.0}).normal_W : Vector3::UnitZ();
    const Quaternion turn = Quaternion::FromTwoVectors(Vector3::UnitZ(), normal);
    place.q.segment<4>(3) = turn.coeffs();
    place.q.head<3>() = turn * Vector3(place.q.head<3>()) + Vector3(x, 0.0, 0.0);
    ForwardKinematics(model, place.q, scratch);
    double least = 1e9;
    for (int foot = 0; foot < static_cast<int>(model.feet.size()); ++foot) {
      for (const Vector3& p : ContactPoints(model, scratch, foot, normal)) {
        const GroundPoint ground = GroundAt(terrain, p.head<2>());
        const double step = ground.patch < 0 ? -1e9 : ground.height_m - p.z();
        place.height_m = std::max(place.height_m, step);
        least = std::min(least, step);
      }
    }
    place.q[2] += place.height_m;
    if (place.height_m - least < 0.02 * model.leg_length_m()) return place;
  }
  ADD_FAILURE() << "no place to stand on";
  return {StandingConfiguration(model), 0.0};
}

class StandingOn : public ::testing::TestWithParam<std::tuple<std::string, std::string>> {};

TEST_P(StandingOn, ARobotThatHoldsItsPostureKeepsStanding) {
  const RobotModel model = standing::Load(std::get<0>(GetParam()));
  const TerrainScale scale = ScaleOf(model);
  const std::string spec = std::get<1>(GetParam()), kind = spec.substr(0, spec.find(':'));
  const Terrain terrain = *MakeTerrain(spec, scale);
  const bool tilted = kind == "slope" || kind == "ramp";
  const double start = scale.front_m + scale.body_length_m;
  // For a gap, the gap is under the robot's middle; otherwise the robot is wholly on the feature.
  const double from = kind == "gap" ? start : start + 0.55 * scale.body_length_m;
  const Place place = FindPlace(model, terrain, from, tilted);
  const MotionPlan plan = standing::Plan(model, 1.0);
  BulletWorld world(model, terrain, place.q, {});
  JointPd controller(model, plan);
  for (int k = 0; k < 800; ++k) world.Step(controller.Update({}));
  double carried = 0.0;
  for (const FootContact& foot : world.feet()) carried += foot.wrench.force_W.z();
  EXPECT_NEAR(carried, model.weight_n(), 0.02 * model.weight_n());
  EXPECT_TRUE(world.body_contacts().empty());
  EXPECT_LT(world.v().norm(), 0.05);
  EXPECT_LT((world.q().head<3>() - place.q.head<3>()).norm(), 0.05 * model.leg_length_m());
  EXPECT_LT((BaseRotation(world.q()) - BaseRotation(place.q)).norm(), 0.15);
}

INSTANTIATE_TEST_SUITE_P(Kinds, StandingOn,
                         ::testing::Combine(::testing::Values("a1", "nao"),
                                            ::testing::Values("flat", "slope", "stairs", "block", "gap",
                                                              "stepping-stones:height_jitter_m=0", "beam", "rough",
                                                              "cinder-blocks:tilt_deg=1,height_m=0.001", "ramp",
                                                              "corridor", "doorway", "maze")),
                         [](const auto& i) {
                           std::string name = std::get<0>(i.param) + "_" + std::get<1>(i.param);
                           name = name.substr(0, name.find(':'));
                           for (char& c : name) c = c == '-' ? '_' : c;
                           return name;
                         });

}  // namespace
}  // namespace gaitwright
