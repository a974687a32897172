// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/model/robot_model.h"
#include "planning/plan/terrain.h"

namespace gaitwright {

/// Whether boxes reach into the ground of a height field, node by node: a box of a robot's room covers hundreds of
/// cells, too many to hold each against it as a solid of its own.
class FieldRoom {
 public:
  /// @param field  must outlive this.
  explicit FieldRoom(const HeightField& field);

  /// True when some node within the box's outline is higher than its lower side. The box stands nearly upright.
  bool Touches(const Shape& box, const Pose& X_WS) const;

  const HeightField& field() const { return field_; }

 private:
  /// Nodes that may lie within a box, last included.
  struct Window {
    int first_column, last_column, first_row, last_row;
  };
  Window Under(const Vector2& middle, double half_x, double half_y) const;
  double HighestIn(const Window& window) const;

  const HeightField& field_;
  int block_columns_;
  std::vector<double> highest_m_;  ///< of blocks of nodes
};

}  // namespace gaitwright
