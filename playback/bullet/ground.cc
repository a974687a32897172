// SPDX-License-Identifier: BSD-3-Clause
#include <BulletCollision/CollisionShapes/btHeightfieldTerrainShape.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kinematics/base/result.h"
#include "kinematics/trajectory/swing_curve.h"
#include "playback/bullet/ground_internal.h"
#include "playback/bullet/robot_body_internal.h"
#include "playback/bullet/world.h"

namespace gaitwright::bullet {
namespace {

constexpr double kBlockDepth = 1.0;     // of the block under a bounded patch [m]
constexpr double kBlockMargin = 0.001;  // collision margin, inside the block [m]
constexpr double kCell = 0.02;          // of a height field [m]
constexpr double kMostCells = 2.5e7;    // of a height field: 0.2 GB
constexpr double kNoGround = -2.0;      // height where the terrain has none [m]

/// Uniform in [-1, 1], from the cell and seed. Steele et al., SplitMix64, OOPSLA 2014, doi:10.1145/2660193.2660195.
double CellValue(std::int64_t ix, std::int64_t iy, std::uint64_t seed) {
  std::uint64_t z = seed * 0x9E3779B97F4A7C15ULL + static_cast<std::uint64_t>(ix) * 0xD1B54A32D192ED03ULL +
                    static_cast<std::uint64_t>(iy) * 0x8CB92BA72F3D8DD7ULL;
  for (int i = 0; i < 2; ++i) {
    z += 0x9E3779B97F4A7C15ULL;
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBULL;
    z ^= z >> 31U;
  }
  return static_cast<double>(z >> 11U) * 0x1.0p-52 - 1.0;
}

}  // namespace

double Bumps::HeightAt(const Vector2& p_W) const {
  const Vector2 cell = (p_W - start) / (0.5 * wavelength);
  const double fx = std::floor(cell.x()), fy = std::floor(cell.y());
  const double u = SmoothStep(cell.x() - fx).value, v = SmoothStep(cell.y() - fy).value;
  const auto ix = static_cast<std::int64_t>(fx), iy = static_cast<std::int64_t>(fy);
  const auto value = [&](std::int64_t dx, std::int64_t dy) { return CellValue(ix + dx, iy + dy, seed); };
  const double noise =
      (1.0 - v) * ((1.0 - u) * value(0, 0) + u * value(1, 0)) + v * ((1.0 - u) * value(0, 1) + u * value(1, 1));
  const double rise = std::clamp(((p_W - start).norm() - free_radius) / (0.5 * wavelength), 0.0, 1.0);
  return amplitude * noise * SmoothStep(rise).value;
}

Ground::Ground(const Terrain& terrain, const WorldOptions& options, const Vector2& start)
    : X_tilt_(GroundTilt(terrain, options, start)) {
  const auto friction = [&](double own) { return options.friction > 0.0 ? options.friction : own; };
  if (options.ground_bumps_m > 0.0) {
    const Bumps bumps{start, options.ground_bumps_m, options.bump_wavelength_m, options.bump_free_radius_m,
                      static_cast<std::uint64_t>(options.seed)};
    AddHeightField(terrain, options, bumps);
    return;
  }
  for (const TerrainPatch& patch : terrain.patches) AddPatch(patch, friction(patch.friction));
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
  // Vertical sides; the margin grows the hull on all sides, so the top starts that much lower.
  const Vector3 down_T = patch.X_WT.linear().transpose() * Vector3(0.0, 0.0, -kBlockDepth);
  for (const Vector2& corner : patch.outline_T) {
    const Vector3 top(corner.x(), corner.y(), -kBlockMargin);
    hull->addPoint(ToBullet(top), false);
    hull->addPoint(ToBullet(Vector3(top + down_T)), false);
  }
  hull->recalcLocalAabb();
  AddObject(std::move(hull), patch.X_WT, friction);
}

void Ground::AddHeightField(const Terrain& terrain, const WorldOptions& options, const Bumps& bumps) {
  const Vector2 extent = options.bumps_to_W - options.bumps_from_W;
  if (!(extent.minCoeff() > 0.0 && (extent / kCell).prod() <= kMostCells)) {
    throw InvalidArgument(fmt::format(
        "ground_bumps_m: bumpy ground of {:.6g} m by {:.6g} m is too large, {:.6g} m^2 are the most; play a "
        "shorter way, or without bumps",
        extent.x(), extent.y(), kMostCells * kCell * kCell));
  }
  const int nx = static_cast<int>(std::ceil(extent.x() / kCell)) + 1;
  const int ny = static_cast<int>(std::ceil(extent.y() / kCell)) + 1;
  heights_.reserve(static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny));
  for (int iy = 0; iy < ny; ++iy) {
    for (int ix = 0; ix < nx; ++ix) {
      const Vector2 p = options.bumps_from_W + kCell * Vector2(ix, iy);
      const GroundPoint ground = GroundAt(terrain, p);
      heights_.push_back(ground.patch < 0 ? kNoGround : ground.height_m + bumps.HeightAt(p));
    }
  }
  const auto [low, high] = std::minmax_element(heights_.begin(), heights_.end());
  const btScalar lowest = *low - 0.01, highest = *high + 0.01;
  auto field = std::make_unique<btHeightfieldTerrainShape>(nx, ny, heights_.data(), lowest, highest, 2, false);
  field->setLocalScaling(btVector3(kCell, kCell, 1.0));
  // Bullet puts the shape's origin at the middle of its box.
  Pose X_WS = Pose::Identity();
  X_WS.translation() << options.bumps_from_W + 0.5 * kCell * Vector2(nx - 1, ny - 1), 0.5 * (lowest + highest);
  AddObject(std::move(field), X_WS, FrictionOf(terrain, options, bumps.start));
}

void Ground::AddTo(btCollisionWorld& world) {
  for (auto& object : objects_) {
    world.addCollisionObject(object.get(), btBroadphaseProxy::StaticFilter, btBroadphaseProxy::CharacterFilter);
  }
}

}  // namespace gaitwright::bullet
