// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "kinematics/base/result.h"
#include "kinematics/collision/fcl_shape_internal.h"
#include "kinematics/collision/grid_prisms_internal.h"

namespace gaitwright {

GridPrisms::GridPrisms(const GridSolid& grid) : grid_(grid) {
  if (grid.columns < 2 || grid.rows < 2 || !(grid.resolution_m > 0.0) ||
      grid.height_m.size() != static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows)) {
    throw InvalidArgument(
        fmt::format("grid '{}' has {} heights for {} columns and {} rows at {} m; it needs 2 or more columns and rows, "
                    "one height for each node and a positive resolution",
                    grid.name, grid.height_m.size(), grid.columns, grid.rows, grid.resolution_m));
  }
  highest_m_ = *std::max_element(grid_.height_m.begin(), grid_.height_m.end());
}

GridPrisms::Window GridPrisms::Near(const fcl::AABBd& box, double within_m) const {
  const auto cell = [&](double at, double origin, int nodes) {
    const double place = std::floor((at - origin) / grid_.resolution_m);
    return static_cast<int>(std::clamp(place, -1.0, static_cast<double>(nodes - 1)));
  };
  const Vector2& origin = grid_.origin_W;
  return {std::max(cell(box.min_.x() - within_m, origin.x(), grid_.columns), 0),
          std::min(cell(box.max_.x() + within_m, origin.x(), grid_.columns), grid_.columns - 2),
          std::max(cell(box.min_.y() - within_m, origin.y(), grid_.rows), 0),
          std::min(cell(box.max_.y() + within_m, origin.y(), grid_.rows), grid_.rows - 2)};
}

/// Lower bound of the distance to a cell: the distance of boxes. If the boxes overlap, the depth is at most the
/// distance upward out of the cell.
double GridPrisms::LowerBound(const fcl::AABBd& box, int column, int row) const {
  const double top = std::max(std::max(Height(column, row), Height(column + 1, row)),
                              std::max(Height(column, row + 1), Height(column + 1, row + 1)));
  const Vector2 low = grid_.origin_W + grid_.resolution_m * Vector2(column, row);
  const auto gap = [&](int axis) {
    const double high = low[axis] + grid_.resolution_m;
    return std::max(std::max(low[axis] - box.max_[axis], box.min_[axis] - high), 0.0);
  };
  const double away = std::hypot(gap(0), gap(1)), above = box.min_.z() - top;
  return above > 0.0 ? std::hypot(away, above) : away > 0.0 ? away : above;
}

const fcl::CollisionObjectd& GridPrisms::Prism(int column, int row, int half) const {
  auto& prism = prisms_[2 * (row * (grid_.columns - 1) + column) + half];
  if (prism != nullptr) return *prism;
  Shape shape;
  shape.type = ShapeType::kMesh;
  const int corners[3][2] = {{0, 0}, {1, 1}, {half, 1 - half}};
  Vector3 middle = Vector3::Zero();
  for (const auto& corner : corners) {
    const Vector2 p_W = grid_.origin_W + grid_.resolution_m * Vector2(column + corner[0], row + corner[1]);
    const Vector3 top(p_W.x(), p_W.y(), Height(column + corner[0], row + corner[1]));
    shape.vertices.push_back(top);
    shape.vertices.push_back(top - grid_.depth_m * Vector3::UnitZ());
    middle += top / 3.0;
  }
  // Relative to its own middle, so that rounding does not grow with the distance from the origin of W.
  for (Vector3& vertex : shape.vertices) vertex -= middle;
  Pose X_WS = Pose::Identity();
  X_WS.translation() = middle;
  prism = std::make_unique<fcl::CollisionObjectd>(FclGeometry(shape), X_WS);
  return *prism;
}

double GridPrisms::CellDistance(const fcl::CollisionObjectd& object, int column, int row) const {
  return std::min(SignedGap(Prism(column, row, 0), object), SignedGap(Prism(column, row, 1), object));
}

double GridPrisms::Distance(const fcl::CollisionObjectd& object, double within_m, bool any_touch) const {
  const fcl::AABBd& box = object.getAABB();
  double best = within_m;
  if (box.min_.z() - highest_m_ >= best) return best;
  const Window cells = Near(box, std::max(within_m, 0.0));
  // The cell with the smallest bound first: its distance excludes most other cells.
  double least = std::numeric_limits<double>::infinity();
  int first_column = -1, first_row = -1;
  for (int row = cells.first_row; row <= cells.last_row; ++row) {
    for (int column = cells.first_column; column <= cells.last_column; ++column) {
      const double bound = LowerBound(box, column, row);
      if (bound < least) least = bound, first_column = column, first_row = row;
    }
  }
  if (!(least < best)) return best;
  best = std::min(best, CellDistance(object, first_column, first_row));
  for (int row = cells.first_row; row <= cells.last_row; ++row) {
    for (int column = cells.first_column; column <= cells.last_column; ++column) {
      if (any_touch && best <= 0.0) return best;
      if (LowerBound(box, column, row) < best) best = std::min(best, CellDistance(object, column, row));
    }
  }
  return best;
}

}  // namespace gaitwright
