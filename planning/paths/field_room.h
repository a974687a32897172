// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/model/robot_model.h"
#include "planning/plan/terrain.h"

namespace gaitwright {

/// Checks node by node whether boxes reach into the ground of a height field. A box of a robot covers hundreds of
/// cells, too many to check each one as a separate solid.
class FieldRoom {
 public:
  /// @param field  must outlive this.
  explicit FieldRoom(const HeightField& field);

  /// True if a node within the box's outline is higher than the lower side of the box. The box must be nearly upright.
  bool Touches(const Shape& box, const Pose& X_WS) const;

  const HeightField& field() const { return field_; }

 private:
  /// Range of nodes that may lie within a box, both ends included.
  struct Window {
    int first_column, last_column, first_row, last_row;
  };
  Window Under(const Vector2& middle, double half_x, double half_y) const;
  double HighestIn(const Window& window) const;

  const HeightField& field_;
  int block_columns_;
  std::vector<double> highest_m_;  ///< of each block of nodes
};

}  // namespace gaitwright
