// SPDX-License-Identifier: BSD-3-Clause
#include "planning/paths/field_room.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gaitwright {
namespace {

constexpr int kBlock = 8;  // nodes along a block's edge

}  // namespace

FieldRoom::FieldRoom(const HeightField& field) : field_(field), block_columns_((field.columns + kBlock - 1) / kBlock) {
  const int block_rows = (field.rows + kBlock - 1) / kBlock;
  highest_m_.assign(static_cast<std::size_t>(block_columns_ * block_rows), -std::numeric_limits<double>::infinity());
  for (int row = 0; row < field.rows; ++row) {
    for (int column = 0; column < field.columns; ++column) {
      double& highest = highest_m_[static_cast<std::size_t>(row / kBlock * block_columns_ + column / kBlock)];
      highest = std::max(highest, field.height_m[static_cast<std::size_t>(row * field.columns + column)]);
    }
  }
}

FieldRoom::Window FieldRoom::Under(const Vector2& middle, double half_x, double half_y) const {
  const Vector2 at = (middle - field_.origin_W) / field_.resolution_m;
  const auto node = [](double place, int nodes) {
    return static_cast<int>(std::clamp(place, -1.0, static_cast<double>(nodes)));
  };
  const double x = half_x / field_.resolution_m, y = half_y / field_.resolution_m;
  return {std::max(node(std::ceil(at.x() - x), field_.columns), 0),
          std::min(node(std::floor(at.x() + x), field_.columns), field_.columns - 1),
          std::max(node(std::ceil(at.y() - y), field_.rows), 0),
          std::min(node(std::floor(at.y() + y), field_.rows), field_.rows - 1)};
}

double FieldRoom::HighestIn(const Window& window) const {
  double highest = -std::numeric_limits<double>::infinity();
  if (window.first_column > window.last_column || window.first_row > window.last_row) return highest;
  for (int row = window.first_row / kBlock; row <= window.last_row / kBlock; ++row) {
    for (int column = window.first_column / kBlock; column <= window.last_column / kBlock; ++column)
      highest = std::max(highest, highest_m_[static_cast<std::size_t>(row * block_columns_ + column)]);
  }
  return highest;
}

bool FieldRoom::Touches(const Shape& box, const Pose& X_WS) const {
  const Vector3 half = 0.5 * box.size, reach = X_WS.linear().cwiseAbs() * half;
  const Window window = Under(X_WS.translation().head<2>(), reach.x(), reach.y());
  if (HighestIn(window) < X_WS.translation().z() - reach.z()) return false;
  const Matrix3 R_SW = X_WS.linear().transpose();
  for (int row = window.first_row; row <= window.last_row; ++row) {
    for (int column = window.first_column; column <= window.last_column; ++column) {
      const Vector2 p_W = field_.origin_W + field_.resolution_m * Vector2(column, row);
      const double height = field_.height_m[static_cast<std::size_t>(row * field_.columns + column)];
      const Vector3 p_S = R_SW * (Vector3(p_W.x(), p_W.y(), height) - X_WS.translation());
      if (std::abs(p_S.x()) <= half.x() && std::abs(p_S.y()) <= half.y() && p_S.z() >= -half.z()) return true;
    }
  }
  return false;
}

}  // namespace gaitwright
