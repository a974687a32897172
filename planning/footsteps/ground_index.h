// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/spatial/convex_hull.h"
#include "planning/plan/terrain.h"

namespace gaitwright {

/// A patch in plan view.
struct GroundSurface {
  /// Ground beyond an edge of the outline.
  enum class Beyond { kLower, kSame, kHigher };

  Polygon outline_W;            ///< counter-clockwise; empty for an infinite surface
  std::vector<Vector2> inward;  ///< unit normal of each edge, from corner i to i + 1
  std::vector<Beyond> beyond;   ///< by edge
  Vector2 lowest_W, highest_W;  ///< corners of the bounding box
  Vector3 plane;                ///< height = plane . (x, y, 1)
  Vector3 normal_W;
  double friction = 0.0;

  /// Height of the surface's plane, inside and outside of its outline [m].
  double HeightAt(const Vector2& p_W) const { return plane.x() * p_W.x() + plane.y() * p_W.y() + plane.z(); }
  /// Smallest distance inside of its edges [m]; negative outside, infinity for an infinite surface.
  double Inside(const Vector2& p_W) const;
};

/// An obstacle in plan view, with its smallest and largest height.
struct ObstacleOutline {
  Polygon outline_W;
  double bottom_m = 0.0, top_m = 0.0;
};

/// Prepares a terrain for many queries of small areas: surfaces and obstacles are listed by the grid cells that they
/// touch. At() gives the same results as GroundAt. The terrain must outlive the object.
class GroundIndex {
 public:
  /// @param cell_m  size of the grid cells; suitable is the size of a foot's surroundings.
  GroundIndex(const Terrain& terrain, double cell_m);

  /// The highest ground at a point; patch is -1 without ground.
  GroundPoint At(const Vector2& p_W) const;

  /// Indices of the patches (not height fields) that may touch a box, without duplicates, in ascending order.
  void PatchesIn(const Vector2& lowest_W, const Vector2& highest_W, std::vector<int>& found) const;
  /// Indices of the obstacles in a box.
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
  Terrain fields_;                       // only the height fields
  std::vector<GroundSurface> surfaces_;  // patches only
  std::vector<ObstacleOutline> obstacles_;
  std::vector<int> endless_;
  Vector2 origin_W_ = Vector2::Zero();
  double cell_m_ = 1.0;
  int columns_ = 0, rows_ = 0;
  std::vector<Cell> cells_;
};

}  // namespace gaitwright
