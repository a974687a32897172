// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// A joint of a skeleton.
struct BvhJoint {
  std::string name;
  int parent = -1;                   ///< index, less than its own; -1 for the root
  Vector3 offset = Vector3::Zero();  ///< from the parent, in the file's unit and axes
  /// Position (0, 1, 2 for x, y, z) and rotation (3, 4, 5) channels in the file's order; rotations are multiplied in
  /// it.
  std::vector<int> channels;
  int first_channel = 0;  ///< column of the first of them
};

/// A BVH file (Biovision hierarchy): skeleton and motion.
struct BvhFile {
  std::vector<BvhJoint> joints;  ///< the root first
  int columns = 0;
  double step_s = 0.0;
  std::vector<double> values;  ///< frames after one another

  int frames() const { return columns == 0 ? 0 : static_cast<int>(values.size()) / columns; }

  /// Position channels of a joint, or its offset where it has none.
  Vector3 PositionOf(int joint, int frame) const;
  /// Rotation of a joint's frame in its parent's. @param radians  of one unit of the file's angles.
  Matrix3 RotationOf(int joint, int frame, double radians) const;
};

/// @throws InvalidArgument `line N: ...` for another format, and for frames with another number of values.
BvhFile ParseBvh(const std::string& text);

}  // namespace gaitwright
