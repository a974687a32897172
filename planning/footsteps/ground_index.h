// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/spatial/convex_hull.h"
#include "planning/plan/terrain.h"

namespace gaitwright {

/// A patch in plan view.
struct GroundSurface {
  /// How the ground goes on beyond an edge of the outline.
  enum class Beyond { kLower, kSame, kHigher };

  Polygon outline_W;            ///< counter-clockwise; empty without end
  std::vector<Vector2> inward;  ///< unit normal of each edge, from corner i to i + 1
  std::vector<Beyond> beyond;   ///< by edge
  Vector2 lowest_W, highest_W;  ///< of the box around it
  Vector3 plane;                ///< height = plane . (x, y, 1)
  Vector3 normal_W;
  double friction = 0.0;

  /// Height of its plane, inside and outside of its outline [m].
  double HeightAt(const Vector2& p_W) const { return plane.x() * p_W.x() + plane.y() * p_W.y() + plane.z(); }
  /// Least distance inside of its edges [m]; negative outside, infinite without end.
  double Inside(const Vector2& p_W) const;
};

/// An obstacle in plan view, with its least and greatest height.
struct ObstacleOutline {
  Polygon outline_W;
  double bottom_m = 0.0, top_m = 0.0;
};

/// Terrain made ready for many questions about small areas: surfaces and obstacles by the cells of a grid that they
/// touch. At answers as GroundAt does. Refers to the terrain, which must outlive it.
class GroundIndex {
 public:
  /// @param cell_m  size of the grid's cells, about that of a foot's surroundings.
  GroundIndex(const Terrain& terrain, double cell_m);

  /// The highest ground at a point; patch -1 without ground.
  GroundPoint At(const Vector2& p_W) const;

  /// Indices of the patches, height fields apart, that may touch a box, each once, in rising order.
  void PatchesIn(const Vector2& lowest_W, const Vector2& highest_W, std::vector<int>& found) const;
  /// Obstacles in a box.
  void ObstaclesIn(const Vector2& lowest_W, const Vector2& highest_W, std::vector<int>& found) const;

  /// An upper bound of the ground's height in a box; -infinity without ground.
  double HighestIn(const Vector2& lowest_W, const Vector2& highest_W) const;

  const std::vector<GroundSurface>& surfaces() const { return surfaces_; }
  const std::vector<ObstacleOutline>& obstacles() const { return obstacles_; }
  const Terrain& terrain() const { return *terrain_; }

 private:
  struct Cell {
    std::vector<int> patches, obstacles;
    double highest_m = 0.0;
  };
  struct CellRange {
    int column_low, column_high, row_low, row_high;
  };

  CellRange Cells(const Vector2& lowest_W, const Vector2& highest_W) const;
  void AddPatch(const TerrainPatch& patch);
  void AddObstacle(const Obstacle& obstacle);
  void MakeGrid(double cell_m);
  void FillCells();
  void LookBeyondEdges();
  template <class Member>
  void Collect(const Vector2& lowest_W, const Vector2& highest_W, Member member, std::vector<int>& found) const;

  const Terrain* terrain_;
  Terrain fields_;                       // the height fields alone
  std::vector<GroundSurface> surfaces_;  // patches only
  std::vector<ObstacleOutline> obstacles_;
  std::vector<int> endless_;
  Vector2 origin_W_ = Vector2::Zero();
  double cell_m_ = 1.0;
  int columns_ = 0, rows_ = 0;
  std::vector<Cell> cells_;
};

}  // namespace gaitwright
