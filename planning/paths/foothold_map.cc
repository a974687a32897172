// SPDX-License-Identifier: BSD-3-Clause
#include "planning/paths/foothold_map.h"

#include <algorithm>
#include <cmath>

namespace gaitwright {
namespace {

constexpr double kCellOfLeg = 0.05;     // a cell's edge in leg lengths
constexpr double kSmallestDisc = 0.04;  // smallest radius of the ground that a foot needs, in leg lengths
constexpr double kShareOfSole = 0.6;    // share of the sole that must lie on one surface
constexpr double kSameSurface = 0.03;   // largest height difference between places of one surface, in leg lengths

/// Index of the tile that contains a cell: rounded towards minus infinity.
int TileIndex(int cell, int tile) { return cell >= 0 ? cell / tile : -((-cell + tile - 1) / tile); }

Shape Ball(double radius) {
  Shape ball;
  ball.type = ShapeType::kSphere;
  ball.size = Vector3(radius, 0.0, 0.0);
  return ball;
}

Eigen::AlignedBox2d ExtentOf(const TerrainPatch& patch) {
  Eigen::AlignedBox2d extent;
  for (const Vector2& corner : patch.outline_T)
    extent.extend(Vector2((patch.X_WT * Vector3(corner.x(), corner.y(), 0.0)).head<2>()));
  return extent;
}

}  // namespace

FootholdMap::FootholdMap(const Terrain& terrain, const ShapeScene& obstacles, const BodySpace& space)
    : terrain_(terrain),
      obstacles_(obstacles),
      resolution_m_(kCellOfLeg * space.leg_length_m),
      foot_radius_m_(std::max(space.foot_radius_m, kSmallestDisc * space.leg_length_m)),
      max_slope_rad_(space.max_slope_rad),
      foot_(Ball(foot_radius_m_)) {
  fields_.height_fields = terrain.height_fields;
  for (const TerrainPatch& patch : terrain.patches) extents_.push_back(ExtentOf(patch));
  const int reach = static_cast<int>(foot_radius_m_ / resolution_m_);
  for (int dx = -reach; dx <= reach; ++dx) {
    for (int dy = -reach; dy <= reach; ++dy) {
      if (std::hypot(dx, dy) * resolution_m_ <= foot_radius_m_) disc_.emplace_back(dx, dy);
    }
  }
}

FootholdMap::Tile& FootholdMap::TileOf(int column, int row) {
  const int i = TileIndex(column, kTile), j = TileIndex(row, kTile);
  if (last_ != nullptr && i == last_column_ && j == last_row_) return *last_;
  last_column_ = i;
  last_row_ = j;
  std::unique_ptr<Tile>& tile = tiles_[(static_cast<std::int64_t>(i) << 32) ^ static_cast<std::uint32_t>(j)];
  if (tile != nullptr) return *(last_ = tile.get());
  tile = std::make_unique<Tile>();
  last_ = tile.get();
  const double edge = kTile * resolution_m_;
  const Vector2 low(i * edge - resolution_m_, j * edge - resolution_m_);
  const Eigen::AlignedBox2d area(low, Vector2(low.array() + edge + 2.0 * resolution_m_));
  for (std::size_t p = 0; p < extents_.size(); ++p) {
    if (extents_[p].isEmpty() || extents_[p].intersects(area)) tile->ground.patches.push_back(terrain_.patches[p]);
  }
  return *tile;
}

const FootholdMap::Ground& FootholdMap::GroundOf(int column, int row) {
  Tile& tile = TileOf(column, row);
  const int i = column - kTile * TileIndex(column, kTile), j = row - kTile * TileIndex(row, kTile);
  Ground& ground = tile.grounds[static_cast<std::size_t>(j * kTile + i)];
  if (ground.known) return ground;
  const Vector2 p_W(column * resolution_m_, row * resolution_m_);
  GroundPoint point = GroundAt(tile.ground, p_W);
  const GroundPoint field = GroundAt(fields_, p_W);
  if (field.patch >= 0 && (point.patch < 0 || field.height_m > point.height_m)) point = field;
  ground.known = true;
  ground.is_ground = point.patch >= 0;
  if (!ground.is_ground) return ground;
  const Vector3& n = point.normal_W;
  ground.height_m = static_cast<float>(point.height_m);
  ground.by_x = static_cast<float>(-n.x() / n.z());
  ground.by_y = static_cast<float>(-n.y() / n.z());
  const double steepest = std::min(std::tan(max_slope_rad_), point.friction);
  ground.tolerable = std::hypot(ground.by_x, ground.by_y) <= steepest * (1.0 + 1e-6);
  return ground;
}

FootholdMap::Cell FootholdMap::Judge(int column, int row) {
  const Ground ground = GroundOf(column, row);
  if (!ground.is_ground) return {Kind::kNoGround};
  if (!ground.tolerable) return {Kind::kTooSteep, ground.height_m, ground.by_x, ground.by_y};
  const float resolution = static_cast<float>(resolution_m_);
  const float apart = static_cast<float>(kSameSurface / kCellOfLeg * resolution_m_);
  std::size_t on = 0;
  for (const auto& [dx, dy] : disc_) {
    const Ground& other = GroundOf(column + dx, row + dy);
    const float here =
        ground.height_m + resolution * (static_cast<float>(dx) * ground.by_x + static_cast<float>(dy) * ground.by_y);
    if (other.is_ground && std::abs(other.height_m - here) <= apart) ++on;
  }
  if (static_cast<double>(on) < kShareOfSole * static_cast<double>(disc_.size()))
    return {Kind::kTooLittle, ground.height_m, ground.by_x, ground.by_y};
  Pose X_WS = Pose::Identity();
  X_WS.translation() = Vector3(column * resolution_m_, row * resolution_m_, ground.height_m + foot_radius_m_);
  const Kind kind = obstacles_.Touches(foot_, X_WS) ? Kind::kTooLittle : Kind::kFoothold;
  return {kind, ground.height_m, ground.by_x, ground.by_y};
}

const FootholdMap::Cell& FootholdMap::At(const Vector2& p_W) {
  const int column = static_cast<int>(std::lround(p_W.x() / resolution_m_));
  const int row = static_cast<int>(std::lround(p_W.y() / resolution_m_));
  Tile& tile = TileOf(column, row);
  const int i = column - kTile * TileIndex(column, kTile), j = row - kTile * TileIndex(row, kTile);
  Cell& cell = tile.cells[static_cast<std::size_t>(j * kTile + i)];
  if (cell.kind == Kind::kUnknown) cell = Judge(column, row);
  return cell;
}

}  // namespace gaitwright
