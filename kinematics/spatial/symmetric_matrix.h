// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// Of six elements, as an inertia is given. They are known before the matrix is begun: Eigen takes what throws between
/// two elements for too few of them.
inline Matrix3 SymmetricMatrix(double xx, double xy, double xz, double yy, double yz, double zz) {
  Matrix3 matrix;
  matrix << xx, xy, xz, xy, yy, yz, xz, yz, zz;
  return matrix;
}

}  // namespace gaitwright
