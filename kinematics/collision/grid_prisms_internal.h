// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcl/fcl.h>

#include <memory>
#include <unordered_map>

#include "kinematics/collision/shape_scene.h"

namespace gaitwright {

/// The prisms under the triangles of a GridSolid. A prism is only created when a shape comes near it.
class GridPrisms {
 public:
  /// @throws InvalidArgument unless there are two columns and rows, a height for each node and a positive resolution.
  explicit GridPrisms(const GridSolid& grid);

  /// Distance of a placed object from the solid, at most within_m; the negative depth if they touch.
  /// @param any_touch  stop at the first touched prism.
  double Distance(const fcl::CollisionObjectd& object, double within_m, bool any_touch) const;

 private:
  /// Cells that may be near a shape.
  struct Window {
    int first_column, last_column, first_row, last_row;
  };
  Window Near(const fcl::AABBd& box, double within_m) const;
  double LowerBound(const fcl::AABBd& box, int column, int row) const;
  double CellDistance(const fcl::CollisionObjectd& object, int column, int row) const;
  const fcl::CollisionObjectd& Prism(int column, int row, int half) const;
  double Height(int column, int row) const {
    return grid_.height_m[static_cast<std::size_t>(row * grid_.columns + column)];
  }

  GridSolid grid_;
  double highest_m_ = 0.0;
  mutable std::unordered_map<int, std::unique_ptr<fcl::CollisionObjectd>> prisms_;
};

}  // namespace gaitwright
