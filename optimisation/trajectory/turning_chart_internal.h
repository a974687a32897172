// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "kinematics/spatial/pose.h"

namespace gaitwright {

/// Three angles x with their first and second time derivatives.
struct AngleJet {
  Vector3 x = Vector3::Zero(), rate = Vector3::Zero(), acceleration = Vector3::Zero();
};

/// An orientation with its motion, and its derivatives by the angles and their derivatives. A change dx of the angles
/// turns R by the small vector E dx in W.
struct ChartedTurn {
  Matrix3 R = Matrix3::Identity();
  Vector3 w = Vector3::Zero(), alpha = Vector3::Zero();
  Matrix3 E = Matrix3::Identity();  ///< also dw / drate and dalpha / dacceleration
  Matrix3 w_by_x = Matrix3::Zero(), alpha_by_x = Matrix3::Zero(), alpha_by_rate = Matrix3::Zero();
};

/// Coordinates of the base's orientation for a spline: R = R1(x0) R2(x1) R3(x2) R_0 with rotations about three axes of
/// W. They are singular at x1 = +-pi/2 only, so that the axis about which a motion turns by much is put first, and it
/// may turn by any angle.
class TurningChart {
 public:
  /// Which axis is first: yaw, pitch and roll; pitch, roll and yaw; or roll, yaw and pitch.
  enum class First { kYaw, kPitch, kRoll };

  TurningChart() = default;
  TurningChart(First first, const Matrix3& R_0);

  /// The chart that is farthest from its singularity over all orientations; yaw first where that is as good.
  static TurningChart For(const std::vector<Matrix3>& R_WB, const Matrix3& R_0);

  /// Whether the first angle turns about the vertical axis.
  bool yaw_first() const { return axes_[0].z() == 1.0; }

  ChartedTurn At(const AngleJet& jet) const;

  /// The angles of an orientation, each within pi of those given (the first and the last), and |x1| <= pi/2.
  Vector3 AnglesOf(const Matrix3& R_WB, const Vector3& near) const;

  /// The angles with the derivatives of a motion.
  AngleJet JetOf(const Matrix3& R_WB, const Vector3& w, const Vector3& alpha, const Vector3& near) const;

 private:
  std::array<Vector3, 3> axes_{Vector3::UnitZ(), Vector3::UnitY(), Vector3::UnitX()};
  Matrix3 R_0_ = Matrix3::Identity();
};

}  // namespace gaitwright
