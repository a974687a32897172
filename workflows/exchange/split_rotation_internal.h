// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// Angles of up to three successive hinges that come nearest to a rotation, and the rotation that is left.
struct SplitAngles {
  VectorX angles;
  double left_rad = 0.0;
};

/// Splits a rotation over hinges in series: R = exp(a_1 q_1) exp(a_2 q_2) ... and what is left, of which the angle is
/// minimised by a damped Gauss-Newton method on SO(3). Axes need not be perpendicular.
/// @param axes  unit vectors at zero angles, in the axes of R. @param near  angles to begin from, as of the frame
/// before: among equal solutions the one near to them is found. @param anywhere  tries other beginnings too.
SplitAngles SplitRotation(const Matrix3& R, const std::vector<Vector3>& axes, const VectorX& near, bool anywhere);

}  // namespace gaitwright
