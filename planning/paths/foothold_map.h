// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

#include "kinematics/collision/shape_scene.h"
#include "planning/paths/body_space.h"
#include "planning/plan/terrain.h"

namespace gaitwright {

/// Possible footholds on a grid through the origin of W; each queried cell is computed once.
class FootholdMap {
 public:
  /// Kind of a cell.
  enum class Kind : std::uint8_t {
    kUnknown,
    kFoothold,
    kNoGround,
    kTooSteep,  ///< steeper than `max_slope_rad`, or than the friction allows
    kTooLittle  ///< less than 60 % of the foot's disc lies on one surface, or an obstacle is there
  };
  /// A possible foothold.
  struct Cell {
    Kind kind = Kind::kUnknown;
    float height_m = 0.0F, by_x = 0.0F, by_y = 0.0F;  ///< height and slope of the ground
  };

  /// @param obstacles  obstacles without footholds; they and the terrain must outlive the map.
  FootholdMap(const Terrain& terrain, const ShapeScene& obstacles, const BodySpace& space);

  /// The cell that contains a point.
  const Cell& At(const Vector2& p_W);

  double resolution_m() const { return resolution_m_; }

 private:
  /// Ground at the centre of a cell.
  struct Ground {
    bool known = false, is_ground = false, tolerable = false;
    float height_m = 0.0F, by_x = 0.0F, by_y = 0.0F;  ///< height and slope
  };
  static constexpr int kTile = 32;  ///< cells along a tile's edge
  struct Tile {
    Terrain ground;  ///< the patches that overlap the tile
    std::vector<Cell> cells = std::vector<Cell>(kTile * kTile);
    std::vector<Ground> grounds = std::vector<Ground>(kTile * kTile);
  };

  Tile& TileOf(int column, int row);
  const Ground& GroundOf(int column, int row);
  Cell Judge(int column, int row);

  const Terrain& terrain_;
  const ShapeScene& obstacles_;
  Terrain fields_;  ///< only the height fields
  double resolution_m_, foot_radius_m_, max_slope_rad_;
  PreparedShape foot_;
  std::vector<Eigen::AlignedBox2d> extents_;  ///< of the patches in plan view; empty for infinite planes
  std::unordered_map<std::int64_t, std::unique_ptr<Tile>> tiles_;
  int last_column_ = 0, last_row_ = 0;  ///< of the last queried tile
  Tile* last_ = nullptr;
  std::vector<std::pair<int, int>> disc_;  ///< cells under a foot, relative to its own cell
};

}  // namespace gaitwright
