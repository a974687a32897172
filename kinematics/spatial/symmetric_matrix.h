// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// A symmetric matrix of six elements, such as an inertia. The elements are evaluated before the matrix is built: if
/// the evaluation of an element threw between two elements, Eigen would report too few elements.
inline Matrix3 SymmetricMatrix(double xx, double xy, double xz, double yy, double yz, double zz) {
  Matrix3 matrix;
  matrix << xx, xy, xz, xy, yy, yz, xz, yz, zz;
  return matrix;
}

}  // namespace gaitwright
