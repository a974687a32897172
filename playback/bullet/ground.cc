// SPDX-License-Identifier: BSD-3-Clause
#include <BulletCollision/CollisionShapes/btHeightfieldTerrainShape.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kinematics/base/result.h"
#include "playback/bullet/ground_internal.h"
#include "playback/bullet/robot_body_internal.h"
#include "playback/engine/world.h"

namespace gaitwright::bullet {
namespace {

constexpr double kBlockMargin = 0.001;  // collision margin, inside the block [m]

constexpr double kObstacleFriction = 0.8;

}  // namespace

Ground::Ground(const Terrain& terrain, const WorldOptions& options, const Bumps& bumps)
    : X_tilt_(GroundTilt(terrain, options, bumps.start)), names_(SolidNames(terrain, bumps.amplitude > 0.0)) {
  const auto friction = [&](double own) { return options.friction > 0.0 ? options.friction : own; };
  for (const Obstacle& obstacle : terrain.obstacles) AddObstacle(obstacle, friction(kObstacleFriction));
  if (bumps.amplitude > 0.0) {
    AddHeightField(BumpyGround(terrain, options, bumps), FrictionOf(terrain, options, bumps.start));
    return;
  }
  for (const TerrainPatch& patch : terrain.patches) AddPatch(patch, friction(patch.friction));
  for (const HeightField& field : terrain.height_fields) AddHeightField(field, friction(field.friction));
}

void Ground::AddObject(std::unique_ptr<btCollisionShape> shape, const Pose& X_WS, double friction) {
  auto object = std::make_unique<btCollisionObject>();
  object->setCollisionShape(shape.get());
  object->setWorldTransform(ToBullet(X_tilt_ * X_WS));
  object->setFriction(friction);
  object->setRestitution(0.0);
  shapes_.push_back(std::move(shape));
  objects_.push_back(std::move(object));
}

void Ground::AddPatch(const TerrainPatch& patch, double friction) {
  if (patch.outline_T.empty()) {
    return AddObject(std::make_unique<btStaticPlaneShape>(btVector3(0.0, 0.0, 1.0), 0.0), patch.X_WT, friction);
  }
  has_edges_ = true;
  auto hull = std::make_unique<btConvexHullShape>();
  hull->setMargin(kBlockMargin);
  // The margin grows the hull on all sides, so the hull starts lower by the margin.
  const Pose X_TW = patch.X_WT.inverse();
  for (const Vector3& corner_W : SolidUnder(patch))
    hull->addPoint(ToBullet(Vector3(X_TW * corner_W - kBlockMargin * Vector3::UnitZ())), false);
  hull->recalcLocalAabb();
  AddObject(std::move(hull), patch.X_WT, friction);
}

void Ground::AddHeightField(HeightField field, double friction) {
  finest_m_ = finest_m_ > 0.0 ? std::min(finest_m_, field.resolution_m) : field.resolution_m;
  heights_.push_back(std::move(field.height_m));  // Bullet keeps only the address of the numbers
  const std::vector<double>& heights = heights_.back();
  const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
  const btScalar lowest = *low - 0.01, highest = *high + 0.01;
  // The flipped diagonal matches HeightField.
  auto shape =
      std::make_unique<btHeightfieldTerrainShape>(field.columns, field.rows, heights.data(), lowest, highest, 2, true);
  shape->setLocalScaling(btVector3(field.resolution_m, field.resolution_m, 1.0));
  // Bullet's origin of the shape is the middle of its bounding box.
  Pose X_WS = Pose::Identity();
  X_WS.translation() << field.origin_W + 0.5 * field.resolution_m * Vector2(field.columns - 1, field.rows - 1),
      0.5 * (lowest + highest);
  AddObject(std::move(shape), X_WS, friction);
}

void Ground::AddObstacle(const Obstacle& obstacle, double friction) {
  std::unique_ptr<btCollisionShape> shape = MakeShape(ShapeOf(obstacle));
  if (!shape) {
    throw InvalidArgument(
        fmt::format("obstacle '{}' is a mesh without vertices; four or more are needed", obstacle.name));
  }
  AddObject(std::move(shape), obstacle.X_WO, friction);
}

std::string Ground::NameOf(const btCollisionObject* object) const {
  for (std::size_t i = 0; i < objects_.size(); ++i) {
    if (objects_[i].get() == object) return names_[i];
  }
  return "";
}

void Ground::AddTo(btCollisionWorld& world) {
  for (auto& object : objects_) {
    world.addCollisionObject(object.get(), btBroadphaseProxy::StaticFilter, btBroadphaseProxy::CharacterFilter);
  }
}

}  // namespace gaitwright::bullet
